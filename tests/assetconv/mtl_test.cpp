#include "bake_rig.hpp"

#include "assetconv/find_file.hpp"
#include "assetconv/mtl.hpp"

namespace atrium {
namespace {

using test::Folder;

std::vector<MtlMaterial> read(const Folder& folder, const std::string& text, Warnings& warnings)
{
    std::vector<MtlMaterial> materials;
    read_mtl(folder.write("x.mtl", text), materials, warnings);
    return materials;
}

TEST(mtl, values_know_whether_they_were_given)
{
    const Folder folder;
    Warnings warnings;
    const auto m = read(folder, "newmtl a #25\r\n\tKd 0.5 .25 1\r\n\tns 10\r\n\tillum 2\r\n", warnings);
    ASSERT_EQ(m.size(), 1u);
    EXPECT_EQ(m[0].name, "a #25");
    EXPECT_EQ(m[0].kd, vec3(0.5f, 0.25f, 1));
    EXPECT_EQ(m[0].ns, 10.0f);
    EXPECT_EQ(m[0].illum, 2);
    EXPECT_FALSE(m[0].ks || m[0].d || m[0].pr || m[0].ni);
    EXPECT_TRUE(warnings.list().empty());
}

TEST(mtl, odd_values)
{
    const Folder folder;
    Warnings warnings;
    const auto m = read(folder,
                        "newmtl a\nKd 0.3\nKs spectral x.rfl\nd -halo 0.4\nTr 0.9\nKe 1 nan 1\nfrob 1\nPs 1\n"
                        "newmtl b\nTr 0.25\nnewmtl a\nKd 1 0 0\nKd 0 1 0\n",
                        warnings);
    ASSERT_EQ(m.size(), 2u);
    EXPECT_EQ(m[0].kd, vec3(0, 1, 0)); // the last definition, and in it the last line
    EXPECT_EQ(m[1].tr, 0.25f);
    EXPECT_EQ(warnings.count("material-duplicate"), 1u);
    EXPECT_EQ(warnings.count("mtl-bad-value"), 2u);
    EXPECT_EQ(warnings.count("mtl-unknown-keyword"), 1u);
    EXPECT_EQ(warnings.count("mtl-ignored-keyword"), 1u);
}

TEST(mtl, d_wins_over_tr_and_one_number_is_grey)
{
    const Folder folder;
    Warnings warnings;
    const auto m = read(folder, "newmtl a\nKd 0.3\nd -halo 0.4\nTr 0.9\n", warnings);
    EXPECT_EQ(m.at(0).kd, vec3(0.3f));
    EXPECT_EQ(m.at(0).d, 0.4f);
    EXPECT_FALSE(m.at(0).tr);
}

TEST(mtl, map_options_and_names)
{
    const auto all = parse_map("-blendu on -cc off -s 2 3 -o 0.5 -mm 0.1 0.9 -bm 2.5 -clamp on -imfchan g -texres 512 "
                               "textures\\my wall.png\t");
    ASSERT_TRUE(all);
    EXPECT_EQ(all->file, "textures/my wall.png");
    EXPECT_EQ(all->scale, vec2(2, 3));
    EXPECT_EQ(all->offset, vec2(0.5f, 0));
    EXPECT_EQ(all->base, 0.1f);
    EXPECT_EQ(all->gain, 0.9f);
    EXPECT_EQ(all->bump, 2.5f);
    EXPECT_EQ(all->channel, 'g');
    EXPECT_TRUE(all->clamp);
    EXPECT_EQ(parse_map("-s 1 1 2.png")->file, "2.png"); // no number, a file
    EXPECT_EQ(parse_map("\"quoted name.png\"")->file, "quoted name.png");
    EXPECT_EQ(parse_map("-strange.png")->file, "-strange.png");
    EXPECT_FALSE(parse_map("-s 1 1 1"));
    EXPECT_FALSE(parse_map(""));
}

TEST(find_file, forgives_what_other_systems_write)
{
    const Folder folder;
    folder.write("Textures/Wall.PNG", "x");
    folder.write("beside.tga", "x");
    InputRecord inputs;
    const auto found = [&](const char* name) { return find_file({folder / ""}, name, true, inputs).has_value(); };
    EXPECT_TRUE(found("textures/wall.png"));
    EXPECT_TRUE(found("C:\\work\\beside.tga"));
    EXPECT_TRUE(found("/elsewhere/beside.tga"));
    EXPECT_TRUE(found("maps/beside.png")); // beside, and another ending
    EXPECT_FALSE(found("missing.png"));
    EXPECT_FALSE(found("../../../../../../dev/zero"));
    EXPECT_FALSE(found("Textures"));
    EXPECT_FALSE(found(""));
}

TEST(find_file, library_names_may_hold_blanks)
{
    const Folder folder;
    folder.write("a b.mtl", "");
    folder.write("c.mtl", "");
    std::vector<std::string> missing;
    InputRecord inputs;
    EXPECT_EQ(find_libraries({folder / ""}, "a b.mtl c.mtl", missing, inputs).size(), 2u);
    EXPECT_TRUE(missing.empty());
    EXPECT_EQ(find_libraries({folder / ""}, "c.mtl gone.mtl", missing, inputs).size(), 1u);
    EXPECT_EQ(missing, std::vector<std::string>{"gone.mtl"});
}

} // namespace
} // namespace atrium
