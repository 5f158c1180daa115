#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/image.hpp"
#include "renderer/core/mapped_file.hpp"

#include <array>
#include <cstring>
#include <exception>
#include <span>

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

namespace atrium {
namespace {

constexpr int max_side = 32768;
// Deflate shrinks at most 1032 to 1, so a file that claims more pixels than this is lying about its size.
constexpr std::uint64_t max_expansion = 1100, free_bytes = std::uint64_t{64} << 20;
// Rendered floats hardly shrink further at higher levels (1 in 500), which only take longer.
constexpr int zip_level = 1;
// OpenEXR's own threads change no byte, but they would compete with the renderer's.
constexpr int no_threads = 0;

constexpr std::array<std::array<const char*, 4>, 5> channel_names{
    {{}, {"Y"}, {"R", "G"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}}; // by count

/// An AtomicFile as OpenEXR's stream. The library's destructor writes the line table and swallows what that throws, so
/// the first failure is kept for rethrow().
class ExrOut : public Imf::OStream {
public:
    explicit ExrOut(AtomicFile& file, const std::string& name) : OStream(name.c_str()), file_(file) {}
    void write(const char* data, int size) override
    {
        try {
            file_.write_at(position_, std::as_bytes(std::span(data, static_cast<std::size_t>(size))));
        } catch (...) {
            if (!failure_) failure_ = std::current_exception();
            throw;
        }
        position_ += static_cast<std::uint64_t>(size);
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }
    void rethrow() const
    {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    AtomicFile& file_;
    std::uint64_t position_ = 0;
    std::exception_ptr failure_;
};

class ExrIn : public Imf::IStream {
public:
    ExrIn(std::span<const std::byte> bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}
    bool read(char* out, int size) override
    {
        const auto count = static_cast<std::uint64_t>(size);
        if (position_ > bytes_.size() || count > bytes_.size() - position_) {
            throw IEX_NAMESPACE::InputExc("the file ends too early");
        }
        std::memcpy(out, bytes_.data() + position_, count);
        position_ += count;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::span<const std::byte> bytes_;
    std::uint64_t position_ = 0;
};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why)
{
    throw Error(ExitCode::input, fmt::format("cannot read the picture \"{}\"", file.string()), file.string(), why,
                "give a whole EXR file with the channels Y, or R and G, or R, G and B");
}

/// The channels to read, in order: R,G,B or R,G or Y or the only one there is. Others (alpha) are left out.
std::vector<std::string> choose_channels(const std::filesystem::path& file, const Imf::ChannelList& list)
{
    std::vector<std::string> names;
    if (list.findChannel("R") != nullptr && list.findChannel("G") != nullptr) {
        names = {"R", "G"};
        if (list.findChannel("B") != nullptr) names.emplace_back("B");
    } else if (list.findChannel("Y") != nullptr && list.findChannel("RY") == nullptr) {
        names = {"Y"};
    } else {
        for (auto c = list.begin(); c != list.end() && names.size() < 20; ++c) names.emplace_back(c.name());
        if (names.size() != 1) {
            refuse(file, fmt::format("its channels are not supported: {}", fmt::join(names, " ")));
        }
    }
    for (const std::string& name : names) {
        const Imf::Channel& channel = list[name.c_str()];
        if (channel.xSampling != 1 || channel.ySampling != 1) refuse(file, "its channel " + name + " is subsampled");
    }
    return names;
}

ImageF read_stream(const std::filesystem::path& file, ExrIn& stream, std::uint64_t file_size, ImageMetadata* metadata)
{
    Imf::Header::setMaxImageSize(max_side, max_side);
    Imf::Header::setMaxTileSize(max_side / 4, max_side / 4);
    Imf::InputFile in(stream, no_threads);
    const Imf::Header& header = in.header();
    const auto& window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > max_side || height > max_side) {
        refuse(file, fmt::format("its size, {} x {}, is beyond {} per side", width, height, max_side));
    }
    const std::vector<std::string> names = choose_channels(file, header.channels());
    const std::uint64_t bytes = static_cast<std::uint64_t>(width * height) * names.size() * sizeof(float);
    if (bytes > free_bytes + max_expansion * file_size) {
        refuse(file, fmt::format("{} bytes cannot hold its {} x {} pixels", file_size, width, height));
    }

    ImageF image(static_cast<int>(width), static_cast<int>(height), static_cast<int>(names.size()));
    const std::size_t x_stride = names.size() * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < names.size(); ++c) {
        frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.values.data() + c, window, x_stride,
                                                x_stride * static_cast<std::size_t>(width)));
    }
    in.setFrameBuffer(frame);
    in.readPixels(window.min.y, window.max.y);

    if (metadata != nullptr) {
        metadata->clear();
        for (auto a = header.begin(); a != header.end(); ++a) {
            const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute());
            if (text != nullptr) (*metadata)[a.name()] = text->value();
        }
    }
    return image;
}

} // namespace

void write_exr(const std::filesystem::path& file, const ImageF& image, const ImageMetadata& metadata)
{
    AtomicFile out(file);
    ExrOut stream(out, file.string());
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        header.zipCompressionLevel() = zip_level;
        Imf::FrameBuffer frame;
        const std::size_t x_stride = static_cast<std::size_t>(image.channels) * sizeof(float);
        for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
            const char* name = channel_names.at(static_cast<std::size_t>(image.channels)).at(c);
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            // OpenEXR's frame buffers serve reading too, so they want a pointer that is not const.
            auto* base = reinterpret_cast<char*>(const_cast<float*>(image.values.data() + c));
            frame.insert(name,
                         Imf::Slice(Imf::FLOAT, base, x_stride, x_stride * static_cast<std::size_t>(image.width)));
        }
        for (const auto& [key, text] : metadata) header.insert(key, Imf::StringAttribute(text));
        Imf::OutputFile exr(stream, header, no_threads);
        exr.setFrameBuffer(frame);
        exr.writePixels(image.height);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        stream.rethrow();
        throw Error(ExitCode::internal, fmt::format("cannot encode \"{}\"", file.string()), "OpenEXR", e.what(),
                    "please report this text with the command");
    }
    stream.rethrow();
    out.commit();
}

ImageF read_exr(const std::filesystem::path& file, ImageMetadata* metadata)
{
    const MappedFile mapped(file);
    ExrIn stream(mapped.bytes(), file.string());
    try {
        return read_stream(file, stream, mapped.bytes().size(), metadata);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        refuse(file, e.what());
    }
}

} // namespace atrium
