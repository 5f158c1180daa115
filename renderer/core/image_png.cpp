#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/image.hpp"
#include "renderer/core/mapped_file.hpp"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <limits>
#include <new>

#include <fmt/format.h>
#include <png.h>

namespace atrium {
namespace {

constexpr int max_side = 32768;
// Deflate shrinks at most 1032 to 1, so a file that claims more pixels than this is lying about its size.
constexpr std::uint64_t max_expansion = 1100, free_bytes = std::uint64_t{64} << 20;
// Level and filter chosen for speed: a noisy 1280x720 frame in 40 ms, 6 % larger than at level 3, which takes 85 ms.
constexpr int zlib_level = 1;

// libpng reports errors by longjmp, which must not skip destructors: what it can jump over are only the functions
// encode(), read_head() and read_rows() below, whose locals have none. Everything with one lives in these two structs.
struct Reason {
    std::array<char, 256> text{};
};

void on_error(png_structp png, png_const_charp message)
{
    auto* reason = static_cast<Reason*>(png_get_error_ptr(png));
    std::strncpy(reason->text.data(), message, reason->text.size() - 1);
    png_longjmp(png, 1);
}

void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

struct Encoder {
    Reason reason;
    std::vector<png_text> texts;
    std::vector<png_const_bytep> rows;
    std::vector<std::byte> out;
    png_structp png = nullptr;
    png_infop info = nullptr;

    Encoder()
    {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &reason, on_error, on_warning);
        info = png != nullptr ? png_create_info_struct(png) : nullptr;
        if (info == nullptr) throw std::bad_alloc();
    }
    ~Encoder() { png_destroy_write_struct(&png, &info); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
};

void on_write(png_structp png, png_bytep data, std::size_t size)
{
    bool appended = false;
    try {
        auto& out = static_cast<Encoder*>(png_get_io_ptr(png))->out;
        const auto* bytes = reinterpret_cast<const std::byte*>(data);
        out.insert(out.end(), bytes, bytes + size);
        appended = true;
    } catch (const std::bad_alloc&) { // an exception must not pass through libpng
    }
    if (!appended) png_error(png, "out of memory");
}

void on_flush(png_structp /*png*/) {}

bool encode(Encoder& e, const Image8& image)
{
    if (setjmp(png_jmpbuf(e.png)) != 0) return false; // NOLINT(cert-err52-cpp): libpng's interface
    png_set_write_fn(e.png, &e, on_write, on_flush);
    png_set_user_limits(e.png, max_side, max_side);
    png_set_compression_level(e.png, zlib_level);
    png_set_filter(e.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    const int color_type = image.channels == 1   ? PNG_COLOR_TYPE_GRAY
                           : image.channels == 3 ? PNG_COLOR_TYPE_RGB
                                                 : PNG_COLOR_TYPE_RGB_ALPHA;
    png_set_IHDR(e.png, e.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (image.channels != 1) png_set_sRGB(e.png, e.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(e.png, e.info, e.texts.data(), static_cast<int>(e.texts.size()));
    png_write_info(e.png, e.info);
    for (png_const_bytep row : e.rows) png_write_row(e.png, row);
    png_write_end(e.png, nullptr);
    return true;
}

struct Decoder {
    Reason reason;
    std::span<const std::byte> rest;
    std::vector<png_bytep> rows;
    png_structp png = nullptr;
    png_infop info = nullptr;

    Decoder()
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reason, on_error, on_warning);
        info = png != nullptr ? png_create_info_struct(png) : nullptr;
        if (info == nullptr) throw std::bad_alloc();
    }
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
};

void on_read(png_structp png, png_bytep data, std::size_t size)
{
    auto* d = static_cast<Decoder*>(png_get_io_ptr(png));
    if (size > d->rest.size()) png_error(png, "the file ends too early");
    std::memcpy(data, d->rest.data(), size);
    d->rest = d->rest.subspan(size);
}

enum class Depth { eight_bits, as_stored };

/// Up to the first pixel, and every colour type turned to grey, RGB or RGBA: 8-bit, or where stored so and wanted, 16.
bool read_head(Decoder& d, Depth depth)
{
    if (setjmp(png_jmpbuf(d.png)) != 0) return false; // NOLINT(cert-err52-cpp): libpng's interface
    png_set_read_fn(d.png, &d, on_read);
    png_set_user_limits(d.png, max_side, max_side);
    png_set_chunk_malloc_max(d.png, png_alloc_size_t{16} << 20);
    png_set_chunk_cache_max(d.png, 1000);
    png_set_crc_action(d.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(d.png, d.info);
    png_set_expand(d.png);
    if (depth == Depth::eight_bits)
        png_set_scale_16(d.png);
    else
        png_set_swap(d.png); // to little-endian
    const int color_type = png_get_color_type(d.png, d.info);
    const bool transparent = png_get_valid(d.png, d.info, PNG_INFO_tRNS) != 0;
    if (color_type == PNG_COLOR_TYPE_GRAY_ALPHA || (color_type == PNG_COLOR_TYPE_GRAY && transparent)) {
        png_set_gray_to_rgb(d.png);
    }
    png_set_interlace_handling(d.png);
    png_read_update_info(d.png, d.info);
    return true;
}

bool read_rows(Decoder& d)
{
    if (setjmp(png_jmpbuf(d.png)) != 0) return false; // NOLINT(cert-err52-cpp): libpng's interface
    png_read_image(d.png, d.rows.data());
    png_read_end(d.png, d.info);
    return true;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why)
{
    throw Error(ExitCode::input, fmt::format("cannot read the picture \"{}\"", file.string()), file.string(), why,
                "give a whole PNG file");
}

} // namespace

void write_png(const std::filesystem::path& file, const Image8& image, const ImageMetadata& metadata)
{
    AtomicFile out(file); // first: an unwritable place is told before the work
    Encoder e;
    e.out.reserve(image.values.size() / 2 + 4096);
    for (const auto& [key, text] : metadata) {
        png_text entry{};
        entry.compression = PNG_ITXT_COMPRESSION_NONE;
        entry.key = const_cast<char*>(key.c_str());
        entry.text = const_cast<char*>(text.c_str());
        entry.itxt_length = text.size();
        entry.lang = const_cast<char*>("");
        entry.lang_key = const_cast<char*>("");
        e.texts.push_back(entry);
    }
    for (int y = 0; y < image.height; ++y) e.rows.push_back(image.at(0, y));
    if (!encode(e, image)) {
        throw Error(ExitCode::internal, fmt::format("cannot encode \"{}\"", file.string()), "libpng",
                    e.reason.text.data(), "please report this text with the command");
    }
    out.write(e.out);
    out.commit();
}

namespace {

/// Reads the head and refuses sizes that the file cannot hold.
void begin(Decoder& d, const std::filesystem::path& file, std::span<const std::byte> bytes, Depth depth)
{
    d.rest = bytes;
    if (!read_head(d, depth)) refuse(file, d.reason.text.data());
    const std::uint64_t width = png_get_image_width(d.png, d.info), height = png_get_image_height(d.png, d.info);
    if (png_get_rowbytes(d.png, d.info) * height > free_bytes + max_expansion * bytes.size())
        refuse(file, fmt::format("{} bytes cannot hold its {} x {} pixels", bytes.size(), width, height));
}

template <class T>
ImageF over_maximum(int width, int height, int channels, const std::vector<T>& values)
{
    ImageF out(width, height, channels);
    constexpr float maximum = std::numeric_limits<T>::max();
    for (std::size_t i = 0; i < values.size(); ++i) out.values[i] = static_cast<float>(values[i]) / maximum;
    return out;
}

} // namespace

ImageF read_png_values(const std::filesystem::path& file)
{
    const MappedFile mapped(file);
    Decoder d;
    begin(d, file, mapped.bytes(), Depth::as_stored);
    const auto width = static_cast<int>(png_get_image_width(d.png, d.info));
    const auto height = static_cast<int>(png_get_image_height(d.png, d.info));
    const int channels = png_get_channels(d.png, d.info);
    if (png_get_bit_depth(d.png, d.info) != 16) {
        const Image8 image = read_png(file);
        return over_maximum(width, height, channels, image.values);
    }
    const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    std::vector<std::uint16_t> values(row * static_cast<std::size_t>(height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        d.rows.push_back(reinterpret_cast<png_bytep>(&values[y * row]));
    if (!read_rows(d)) refuse(file, d.reason.text.data());
    return over_maximum(width, height, channels, values);
}

Image8 read_png(const std::filesystem::path& file, ImageMetadata* metadata)
{
    const MappedFile mapped(file);
    Decoder d;
    begin(d, file, mapped.bytes(), Depth::eight_bits);
    const std::uint64_t width = png_get_image_width(d.png, d.info), height = png_get_image_height(d.png, d.info);
    Image8 image(static_cast<int>(width), static_cast<int>(height), png_get_channels(d.png, d.info));
    for (int y = 0; y < image.height; ++y) d.rows.push_back(image.at(0, y));
    if (!read_rows(d)) refuse(file, d.reason.text.data());

    if (metadata != nullptr) {
        png_textp texts = nullptr;
        const int count = png_get_text(d.png, d.info, &texts, nullptr);
        metadata->clear();
        for (int i = 0; i < count; ++i) {
            const std::size_t size = std::max(texts[i].text_length, texts[i].itxt_length);
            (*metadata)[texts[i].key] = texts[i].text == nullptr ? "" : std::string(texts[i].text, size);
        }
    }
    return image;
}

} // namespace atrium
