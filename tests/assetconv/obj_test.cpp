#include "bake_rig.hpp"

#include "assetconv/obj.hpp"
#include "assetconv/text_lines.hpp"
#include "renderer/core/error.hpp"

#include <fmt/format.h>

#include <cstring>

namespace atrium {
namespace {

using test::Folder;

ObjFile read(const Folder& folder, const std::string& text, Warnings& warnings)
{
    return read_obj(folder.write("x.obj", text), warnings);
}

ObjFile read(const Folder& folder, const std::string& text)
{
    Warnings warnings;
    return read(folder, text, warnings);
}

const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(text_lines, line_ends_continuations_and_blanks)
{
    const std::string text = "\xEF\xBB\xBF a b\t\r\n# comment\r\n\r\nc \\\r\nd\re";
    TextLines lines(std::as_bytes(std::span(text)));
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.text(), "a b");
    EXPECT_EQ(lines.number(), 1u);
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.text(), "c  d");
    EXPECT_EQ(lines.number(), 4u);
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.text(), "e");
    EXPECT_EQ(lines.number(), 6u);
    EXPECT_FALSE(lines.next());
}

TEST(obj, reads_the_same_with_any_line_end)
{
    const Folder folder;
    const std::string plain = points + "vt 0.5 0.25\ng wall\nusemtl a b\nf 1/1 2/1 3/1 4/1\n";
    std::string crlf, continued;
    for (const char c : plain) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    continued = points + "vt 0.5 \\\n 0.25\n\tg   wall  \nusemtl  a b \nf 1/1 2/1 \\\n3/1 4/1 # end\n";
    for (const std::string& text : {plain, crlf, continued}) {
        const ObjFile obj = read(folder, text);
        ASSERT_EQ(obj.faces.size(), 1u);
        EXPECT_EQ(obj.faces[0].corner_count, 4u);
        EXPECT_EQ(obj.groups.at(0).name, "wall");
        EXPECT_EQ(obj.materials.at(0).name, "a b");
        EXPECT_EQ(obj.uvs.at(0), vec2(0.5f, 0.25f));
    }
}

TEST(obj, negative_indices_count_from_the_line_they_stand_on)
{
    const Folder folder;
    const ObjFile obj = read(folder, points + "f -4 -3 -2\nv 9 9 9\nf -1 -2 -3\n");
    ASSERT_EQ(obj.corners.size(), 6u);
    EXPECT_EQ(obj.corners[0].position, 0);
    EXPECT_EQ(obj.corners[2].position, 2);
    EXPECT_EQ(obj.corners[3].position, 4);
    EXPECT_EQ(obj.corners[5].position, 2);
}

TEST(obj, faces_with_bad_indices_are_dropped_and_counted)
{
    const Folder folder;
    Warnings warnings;
    const ObjFile obj =
        read(folder,
             points + "vt 0 0\nf 0 1 2\nf 1 2 5\nf 1 2 -5\nf 1/1 2/1 3/2\nf 1//1 2//1 3//1\nf 1/0 2/1 3/1\n"
                      "f 1 2\nf 1 2 99999999999999999999\nf 1 2 3\n",
             warnings);
    EXPECT_EQ(obj.faces.size(), 1u);
    EXPECT_EQ(obj.corners.size(), 3u);
    EXPECT_EQ(warnings.count("face-bad-index"), 7u);
    EXPECT_EQ(warnings.count("face-too-few-corners"), 1u);
    EXPECT_EQ(warnings.list()[0].first, "x.obj:6");
}

TEST(obj, numbers_that_are_none_take_their_faces_along)
{
    const Folder folder;
    Warnings warnings;
    const ObjFile obj =
        read(folder, points + "v nan 0 0\nv 1.#QNAN 0 0\nv 1e999 0 0\nf 1 2 5\nf 1 2 6\nf 1 2 7\nf 1 2 3\n", warnings);
    EXPECT_EQ(obj.faces.size(), 1u);
    EXPECT_EQ(warnings.count("number-bad"), 3u);
}

TEST(obj, groups_are_known_by_name_and_object)
{
    const Folder folder;
    const ObjFile obj = read(folder, points + "f 1 2 3\ng a\nf 1 2 3\ng b c\nf 1 2 3\ng a\nf 1 2 3\n"
                                              "o house\ng a\nf 1 2 3\no house\nf 1 2 3\ng\nf 1 2 3\ng\nf 1 2 3\n");
    std::vector<std::string> names;
    for (const ObjFace& f : obj.faces) names.push_back(obj.groups[f.group].name);
    EXPECT_EQ(names, (std::vector<std::string>{"", "a", "b c", "a", "a", "house", "house", "house"}));
    EXPECT_EQ(obj.faces[1].group, obj.faces[3].group);
    EXPECT_NE(obj.faces[1].group, obj.faces[4].group); // the house's own "a"
    EXPECT_NE(obj.faces[6].group, obj.faces[7].group); // every unnamed group is one of its own
}

TEST(obj, smoothing_statements_reach_their_faces)
{
    const Folder folder;
    const ObjFile obj = read(folder, points + "f 1 2 3\ns 7\nf 1 2 3\ns off\nf 1 2 3\n");
    EXPECT_EQ(obj.faces.at(0).smoothing, smoothing_unset);
    EXPECT_EQ(obj.faces.at(1).smoothing, 7u);
    EXPECT_EQ(obj.faces.at(2).smoothing, 0u);
}

TEST(obj, polygons_of_more_than_255_corners_stay_whole)
{
    const Folder folder;
    std::string text, face = "f";
    for (int i = 0; i < 1000; ++i) {
        text += fmt::format("v {} {} 0\n", std::cos(i * 0.00628), std::sin(i * 0.00628));
        face += fmt::format(" {}", i + 1);
    }
    EXPECT_EQ(read(folder, text + face + "\n").faces.at(0).corner_count, 1000u);
}

TEST(obj, statements_without_meaning_are_counted)
{
    const Folder folder;
    Warnings warnings;
    (void)read(folder, points + "l 1 2\np 1\nfrob 1\n", warnings);
    EXPECT_EQ(warnings.count("obj-ignored-statement"), 2u);
    EXPECT_EQ(warnings.count("obj-unknown-statement"), 1u);
}

TEST(obj, a_missing_file_is_an_input_error)
{
    Warnings warnings;
    try {
        (void)read_obj("/nowhere/at/all.obj", warnings);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::input);
    }
}

} // namespace
} // namespace atrium
