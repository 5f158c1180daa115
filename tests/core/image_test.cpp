#include "renderer/core/atomic_file.hpp"
#include "renderer/core/image.hpp"
#include "renderer/core/mapped_file.hpp"
#include "tests/core/expect_error.hpp"
#include "tests/core/temp_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace atrium {
namespace {

using test::error_of;
using test::expect_error;
using test::TempFolder;

const ImageMetadata some_metadata{
    {"atrium.settings", "ao.method = \"gtao\"\nao.radius = 0.5"}, {"empty", ""}, {"place", "Ståhl — 光"}};

std::string bytes_of(const std::filesystem::path& file)
{
    const MappedFile mapped(file);
    const auto* data = reinterpret_cast<const char*>(mapped.bytes().data());
    return {data, data + mapped.bytes().size()};
}

Image8 pattern8(int width, int height, int channels)
{
    Image8 image(width, height, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<std::uint8_t>(i * 37 % 251);
    return image;
}

TEST(png, round_trip_of_pixels_and_metadata)
{
    const TempFolder folder;
    for (const int channels : {1, 3, 4}) {
        const Image8 image = pattern8(33, 17, channels);
        write_png(folder / "a.png", image, some_metadata);
        ImageMetadata metadata{{"stale", "x"}};
        const Image8 back = read_png(folder / "a.png", &metadata);
        EXPECT_EQ(back.width, 33);
        EXPECT_EQ(back.height, 17);
        EXPECT_EQ(back.channels, channels);
        EXPECT_EQ(back.values, image.values);
        EXPECT_EQ(metadata, some_metadata);
    }
}

TEST(png, same_input_same_bytes_and_no_date_nor_name)
{
    const TempFolder folder;
    write_png(folder / "first.png", pattern8(40, 30, 3), some_metadata);
    write_png(folder / "second.png", pattern8(40, 30, 3), some_metadata);
    const std::string bytes = bytes_of(folder / "first.png");
    EXPECT_EQ(bytes, bytes_of(folder / "second.png"));
    EXPECT_EQ(bytes.find("tIME"), std::string::npos);
    EXPECT_EQ(bytes.find("first"), std::string::npos);
    EXPECT_NE(bytes.find("iTXt"), std::string::npos);
    EXPECT_NE(bytes.find("ao.radius = 0.5"), std::string::npos) << "the text must be stored uncompressed";
    EXPECT_EQ(folder.entries(), 2);
}

TEST(png, every_cut_and_flipped_byte_is_refused_or_read_without_a_crash)
{
    const TempFolder folder;
    write_png(folder / "a.png", pattern8(20, 10, 3), {{"key", "text"}});
    const std::string whole = bytes_of(folder / "a.png");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_text_file(folder / "b.png", whole.substr(0, size));
        expect_error([&] { (void)read_png(folder / "b.png"); }, ExitCode::input, "b.png");
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        write_text_file(folder / "b.png", damaged);
        // Every chunk has a checksum, and the signature and lengths are checked.
        expect_error([&] { (void)read_png(folder / "b.png"); }, ExitCode::input, "b.png");
    }
}

TEST(png, a_small_file_that_claims_many_pixels_is_refused_before_memory_is_taken)
{
    // 32768 x 32768 RGBA, an empty IDAT, IEND; the checksums are right.
    using namespace std::string_literals;
    const std::string lie = "\x89PNG\r\n\x1a\n"s + "\0\0\0\rIHDR\0\0\x80\0\0\0\x80\0\x08\x06\0\0\0"s +
                            "\xc4\x7c\xa3\x7f"s + "\0\0\0\0IDAT\x35\xaf\x06\x1e"s + "\0\0\0\0IEND\xae\x42\x60\x82"s;
    const TempFolder folder;
    write_text_file(folder / "lie.png", lie);
    const auto error = error_of([&] { (void)read_png(folder / "lie.png"); });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->code(), ExitCode::input);
    EXPECT_NE(error->why().find("cannot hold"), std::string::npos) << error->text();
}

TEST(png, missing_file_and_unwritable_place)
{
    const TempFolder folder;
    expect_error([&] { (void)read_png(folder / "none.png"); }, ExitCode::input, "none.png", "No such file");
    expect_error([&] { write_png(folder / "no" / "a.png", pattern8(2, 2, 3)); }, ExitCode::environment, "No such file");
    expect_error([&] { write_png("/dev/full", pattern8(64, 64, 3)); }, ExitCode::environment, "No space left");
}

ImageF pattern_f(int width, int height, int channels)
{
    ImageF image(width, height, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        image.values[i] = std::sin(static_cast<float>(i)) * std::pow(10.0f, static_cast<float>(i % 70) - 35.0f);
    }
    image.values[0] = std::numeric_limits<float>::infinity();
    return image;
}

TEST(exr, round_trip_of_floats_and_metadata)
{
    const TempFolder folder;
    for (const int channels : {1, 2, 3}) {
        const ImageF image = pattern_f(37, 21, channels);
        write_exr(folder / "a.exr", image, some_metadata);
        ImageMetadata metadata{{"stale", "x"}};
        const ImageF back = read_exr(folder / "a.exr", &metadata);
        EXPECT_EQ(back.width, 37);
        EXPECT_EQ(back.height, 21);
        EXPECT_EQ(back.channels, channels);
        EXPECT_EQ(back.values, image.values) << channels << " channels";
        EXPECT_EQ(metadata, some_metadata);
    }
}

TEST(exr, same_input_same_bytes_and_no_date_nor_name)
{
    const TempFolder folder;
    write_exr(folder / "first.exr", pattern_f(64, 40, 3), some_metadata);
    write_exr(folder / "second.exr", pattern_f(64, 40, 3), some_metadata);
    const std::string bytes = bytes_of(folder / "first.exr");
    EXPECT_EQ(bytes, bytes_of(folder / "second.exr"));
    EXPECT_EQ(bytes.find("capDate"), std::string::npos);
    EXPECT_EQ(bytes.find("first"), std::string::npos);
    EXPECT_EQ(folder.entries(), 2);
}

TEST(exr, every_cut_is_refused_and_no_flipped_byte_crashes)
{
    const TempFolder folder;
    write_exr(folder / "a.exr", pattern_f(6, 4, 3), {{"key", "text"}});
    const std::string whole = bytes_of(folder / "a.exr");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_text_file(folder / "b.exr", whole.substr(0, size));
        expect_error([&] { (void)read_exr(folder / "b.exr"); }, ExitCode::input, "b.exr");
    }
    int refused = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ (i % 2 == 0 ? 0x01 : 0x80));
        write_text_file(folder / "b.exr", damaged);
        // EXR has no checksums: a changed window or pixel can be read. What is refused is refused as input.
        const auto error = error_of([&] { (void)read_exr(folder / "b.exr"); });
        if (!error) continue;
        ++refused;
        EXPECT_EQ(error->code(), ExitCode::input) << error->text();
    }
    EXPECT_GT(refused, 100);
}

TEST(exr, a_disk_that_fills_up_while_pixels_are_written_leaves_nothing)
{
    const TempFolder folder;
    struct rlimit was {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &was), 0);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit small {
        2000, was.rlim_max
    };
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto error = error_of([&] { write_exr(folder / "a.exr", pattern_f(64, 64, 3)); });
    ::setrlimit(RLIMIT_FSIZE, &was);
    std::signal(SIGXFSZ, old_handler);
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->code(), ExitCode::environment) << error->text();
    EXPECT_EQ(error->why(), "File too large");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(exr, missing_file_wrong_file_and_full_disk)
{
    const TempFolder folder;
    expect_error([&] { (void)read_exr(folder / "none.exr"); }, ExitCode::input, "No such file");
    write_png(folder / "a.png", pattern8(8, 8, 3));
    expect_error([&] { (void)read_exr(folder / "a.png"); }, ExitCode::input, "not an image file");
    expect_error([&] { write_exr("/dev/full", pattern_f(64, 64, 3)); }, ExitCode::environment, "No space left");
}

} // namespace
} // namespace atrium
