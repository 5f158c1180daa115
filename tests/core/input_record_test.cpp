#include "renderer/core/input_record.hpp"

#include "expect_error.hpp"
#include "renderer/core/atomic_file.hpp"
#include "temp_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

namespace atrium {
namespace {

namespace fs = std::filesystem;
using test::expect_error;
using test::TempFolder;

/// The record after a round trip through its file.
InputRecord stored(const InputRecord& record)
{
    return InputRecord::from_json(record.to_json(), "record.json");
}

void rewrite(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text; // in place: the inode stays
}

TEST(input_record, a_file_of_other_bytes_is_a_change_and_a_touched_one_is_not)
{
    const TempFolder folder;
    const fs::path file = folder / "a \xff\"%41.mtl"; // a name that is no UTF-8
    write_text_file(file, "Kd 1 0 0\n");
    InputRecord record;
    record.add_file(file);
    record.add_file(file); // once is enough
    record.add_file(folder / "missing");
    EXPECT_EQ(stored(record).files(), std::vector<fs::path>{file});
    EXPECT_EQ(stored(record).change(), "");

    const auto time = fs::last_write_time(file);
    fs::last_write_time(file, time + std::chrono::hours(1));
    EXPECT_EQ(stored(record).change(), "") << "the same bytes";
    rewrite(file, "Kd 0 1 0\n");
    fs::last_write_time(file, time); // size and time as before
    EXPECT_NE(stored(record).change().find("has changed"), std::string::npos);
    rewrite(file, "Kd 1 0 0\n");
    EXPECT_EQ(stored(record).change(), "");
    fs::remove(file);
    EXPECT_NE(stored(record).change().find("is gone"), std::string::npos);
}

TEST(input_record, a_name_that_was_missing_is_a_change_when_it_comes_and_others_are_not)
{
    const TempFolder folder;
    InputRecord record;
    record.add_search(folder.path(), "Wall.png", entries_like(folder.path(), "Wall.png"));
    EXPECT_EQ(stored(record).change(), "");
    write_text_file(folder / "scene.atrium", "an output next to it");
    EXPECT_EQ(stored(record).change(), "");
    write_text_file(folder / "WALL.PNG", "x");
    EXPECT_NE(stored(record).change().find("Wall.png"), std::string::npos);

    record = InputRecord();
    record.add_search(folder.path(), "wall.png", entries_like(folder.path(), "wall.png"));
    EXPECT_EQ(stored(record).change(), "");
    write_text_file(folder / "wall.png", "x"); // would be taken before WALL.PNG
    EXPECT_NE(stored(record).change(), "");
}

TEST(input_record, keeps_its_notes_and_the_hash_of_its_result)
{
    InputRecord record;
    record.result = 0xfedcba9876543210;
    record.notes = {"1 x mtl-missing: \xff"};
    const InputRecord back = stored(record);
    EXPECT_EQ(back.result, record.result);
    EXPECT_EQ(back.notes.size(), 1u);
}

TEST(input_record, a_damaged_one_is_an_error_and_nothing_worse)
{
    const TempFolder folder;
    write_text_file(folder / "a", "a");
    InputRecord record;
    record.add_file(folder / "a");
    record.add_search(folder.path(), "b", {});
    const std::string text = record.to_json();
    expect_error([] { static_cast<void>(InputRecord::from_json("", "r.json")); }, ExitCode::input, "r.json");
    for (std::size_t size = 0; size + 2 < text.size(); ++size) {
        expect_error([&] { static_cast<void>(InputRecord::from_json(text.substr(0, size), "r.json")); },
                     ExitCode::input, "r.json");
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string flipped = text;
        flipped[i] = static_cast<char>(flipped[i] ^ 0x15);
        try {
            static_cast<void>(InputRecord::from_json(flipped, "r.json").change());
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::input);
        }
    }
}

TEST(input_record, one_that_is_not_kept_stays_empty)
{
    const TempFolder folder;
    write_text_file(folder / "a", "a");
    InputRecord none(false);
    none.add_file(folder / "a");
    none.add_search(folder.path(), "b", {});
    fs::remove(folder / "a");
    write_text_file(folder / "b", "b");
    EXPECT_TRUE(none.files().empty());
    EXPECT_EQ(none.change(), "");
}

} // namespace
} // namespace atrium
