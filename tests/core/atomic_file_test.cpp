#include "renderer/core/atomic_file.hpp"
#include "renderer/core/mapped_file.hpp"
#include "tests/core/expect_error.hpp"
#include "tests/core/temp_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <sys/fsuid.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace atrium {
namespace {

namespace fs = std::filesystem;
using test::expect_error;
using test::TempFolder;

std::string read_all(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// root may write anywhere; as nobody this thread meets the permissions that a user meets.
class AsNobody {
public:
    AsNobody() : was_(static_cast<uid_t>(::setfsuid(65534))) {}
    ~AsNobody() { ::setfsuid(was_); }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

private:
    uid_t was_;
};

TEST(atomic_file, appears_only_with_commit_and_then_whole)
{
    const TempFolder folder;
    const fs::path target = folder / "out.txt";
    {
        AtomicFile file(target);
        file.write("hello");
        EXPECT_FALSE(fs::exists(target));
        EXPECT_EQ(file.temporary().parent_path(), folder.path());
        EXPECT_EQ(file.temporary().filename().string().rfind(".atrium-", 0), 0u);
        file.write(" world");
        file.commit();
    }
    EXPECT_EQ(read_all(target), "hello world");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(atomic_file, without_commit_leaves_nothing_and_keeps_the_old_file)
{
    const TempFolder folder;
    write_text_file(folder / "out.txt", "old");
    {
        AtomicFile file(folder / "out.txt");
        file.write("new");
    }
    EXPECT_EQ(read_all(folder / "out.txt"), "old");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(atomic_file, write_at_grows_the_file_with_zeros)
{
    const TempFolder folder;
    AtomicFile file(folder / "out.bin");
    const std::array<std::byte, 2> bytes{std::byte{'a'}, std::byte{'b'}};
    file.write_at(3, bytes);
    file.write_at(0, bytes);
    file.commit();
    EXPECT_EQ(read_all(folder / "out.bin"), (std::string{'a', 'b', '\0', 'a', 'b'}));
}

TEST(atomic_file, follows_the_umask_like_any_new_file)
{
    const TempFolder folder;
    const mode_t was = ::umask(022);
    write_text_file(folder / "out.txt", "x");
    ::umask(was);
    struct stat status {};
    ASSERT_EQ(::stat((folder / "out.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0644u);
}

TEST(atomic_file, writes_through_a_symbolic_link)
{
    const TempFolder folder;
    write_text_file(folder / "real.txt", "old");
    fs::create_symlink("real.txt", folder / "link.txt");
    write_text_file(folder / "link.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
    EXPECT_EQ(read_all(folder / "real.txt"), "new");
}

TEST(atomic_file, a_folder_as_target_is_an_error)
{
    const TempFolder folder;
    expect_error([&] { AtomicFile file(folder.path()); }, ExitCode::environment, folder.path().string(), "directory",
                 "name a file");
    expect_error([&] { AtomicFile file(folder / "none" / "out.txt"); }, ExitCode::environment, "No such file",
                 "create the folder");
    expect_error([&] { AtomicFile file(""); }, ExitCode::environment);
    EXPECT_EQ(folder.entries(), 0);
}

TEST(atomic_file, a_read_only_folder_is_an_error_and_stays_empty)
{
    const TempFolder folder;
    fs::permissions(folder.path(), fs::perms(0555));
    {
        const AsNobody nobody;
        expect_error([&] { AtomicFile file(folder / "out.txt"); }, ExitCode::environment, "Permission denied",
                     "may write to");
    }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(atomic_file, a_device_is_written_to_and_not_replaced)
{
    write_text_file("/dev/null", "x");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    expect_error([] { write_text_file("/dev/full", "x"); }, ExitCode::environment, "/dev/full", "No space left",
                 "free some space");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(atomic_file, a_signal_handler_can_discard_what_is_open)
{
    const TempFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGTERM, [](int) {
            discard_open_atomic_files();
            ::_exit(0);
        });
        AtomicFile first(folder / "a"), second(folder / "b");
        write_text_file(folder / "whole", "whole");
        std::raise(SIGTERM);
        ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_EQ(read_all(folder / "whole"), "whole");
}

TEST(atomic_file, more_open_files_than_the_table_holds_still_work)
{
    const TempFolder folder;
    std::vector<std::unique_ptr<AtomicFile>> files;
    files.reserve(100);
    for (int i = 0; i < 100; ++i) files.push_back(std::make_unique<AtomicFile>(folder / std::to_string(i)));
    for (const auto& file : files) file->commit();
    EXPECT_EQ(folder.entries(), 100);
}

TEST(mapped_file, shows_the_bytes)
{
    const TempFolder folder;
    write_text_file(folder / "in", "abc");
    MappedFile file(folder / "in");
    ASSERT_EQ(file.bytes().size(), 3u);
    EXPECT_EQ(file.bytes()[1], std::byte{'b'});
    const MappedFile moved = std::move(file);
    EXPECT_EQ(moved.bytes().size(), 3u);

    write_text_file(folder / "empty", "");
    EXPECT_TRUE(MappedFile(folder / "empty").bytes().empty());
}

TEST(mapped_file, refuses_what_is_no_readable_file)
{
    const TempFolder folder;
    expect_error([&] { MappedFile file(folder / "none"); }, ExitCode::input, "none", "No such file");
    expect_error([&] { MappedFile file(folder.path()); }, ExitCode::input, "folder");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    expect_error([&] { MappedFile file(folder / "pipe"); }, ExitCode::input, "not a regular file"); // without waiting
    write_text_file(folder / "secret", "x");
    fs::permissions(folder / "secret", fs::perms::none);
    fs::permissions(folder.path(), fs::perms(0755));
    const AsNobody nobody;
    expect_error([&] { MappedFile file(folder / "secret"); }, ExitCode::input, "Permission denied");
}

} // namespace
} // namespace atrium
