// The archive section: a Boost.Serialization binary archive of everything in a Scene.
//
// Boost's own loading of strings and vectors makes room for whatever count the bytes name. Here every count is held
// against what is left of the archive first, and against a limit; bools and enums are read as integers and checked.
// Each table is one versioned object of Boost's, its elements are plain fields: so a hostile archive that turns on
// Boost's object tracking gains nothing from it.

#include "renderer/scene/bake_internal.hpp"

#include <boost/archive/archive_exception.hpp>
#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/split_member.hpp>
#include <boost/serialization/tracking.hpp>
#include <boost/serialization/version.hpp>
#include <fmt/format.h>

#include <concepts>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <type_traits>

namespace atrium::bake {
namespace {

constexpr int texture_format_count = static_cast<int>(TextureFormat::bc5_unorm) + 1;

/// Reads the mapped bytes where they are.
class InputBuffer : public std::streambuf {
public:
    explicit InputBuffer(std::span<const std::byte> bytes)
    {
        char* begin = const_cast<char*>(reinterpret_cast<const char*>(bytes.data())); // never written: no put area
        setg(begin, begin, begin + bytes.size());
    }
    [[nodiscard]] std::uint64_t remaining() const { return static_cast<std::uint64_t>(egptr() - gptr()); }
    [[nodiscard]] std::uint64_t position() const { return static_cast<std::uint64_t>(gptr() - eback()); }
};

struct Damage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The fields of each type in the order of the file, said once for writing, reading and sizing.

template <class T, class Type>
concept Is = std::same_as<std::remove_const_t<T>, Type>;

template <class Io, Is<vec3> V>
void fields(Io& io, V& v)
{
    io.number(v.x);
    io.number(v.y);
    io.number(v.z);
}

template <class Io, Is<Bounds> B>
void fields(Io& io, B& b)
{
    fields(io, b.min);
    fields(io, b.max);
}

template <class Io, Is<Material> M>
void fields(Io& io, M& m)
{
    io.text(m.name);
    io.choice(m.cls, material_class_count);
    io.flag(m.two_sided);
    fields(io, m.base_color);
    io.number(m.opacity);
    io.number(m.alpha_cutoff);
    io.number(m.roughness);
    io.number(m.metallic);
    io.number(m.specular);
    fields(io, m.emission);
    io.number(m.base_color_texture);
    io.number(m.normal_texture);
    io.number(m.surface_texture);
    io.number(m.emission_texture);
}

template <class Io, Is<Texture> T>
void fields(Io& io, T& t)
{
    io.text(t.file);
    io.number(t.width);
    io.number(t.height);
    io.number(t.mips);
    io.choice(t.format, texture_format_count);
    io.flag(t.clamp);
    io.number(t.offset);
    io.number(t.size);
}

template <class Io, Is<Mesh> M>
void fields(Io& io, M& m)
{
    io.text(m.name);
    io.number(m.material);
    io.number(m.first_index);
    io.number(m.index_count);
    io.number(m.first_vertex);
    io.number(m.vertex_count);
    io.number(m.first_cluster);
    io.number(m.cluster_count);
    io.flag(m.two_sided);
    fields(io, m.bounds);
}

template <class Io, Is<Cluster> C>
void fields(Io& io, C& c)
{
    fields(io, c.centre);
    io.number(c.radius);
    fields(io, c.cone_axis);
    io.number(c.cone_cutoff);
    io.number(c.first_index);
    io.number(c.index_count);
}

template <class Io, Is<BakeWarning> W>
void fields(Io& io, W& w)
{
    io.text(w.kind);
    io.number(w.count);
    io.text(w.first);
}

template <class Archive>
struct Writer {
    Archive& archive;

    template <class T>
    void number(const T& value)
    {
        archive << value;
    }
    void flag(bool value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }
    template <class E>
    void choice(const E& value, int)
    {
        number(static_cast<std::uint8_t>(value));
    }
    void text(const std::string& value)
    {
        number(static_cast<std::uint64_t>(value.size()));
        archive.save_binary(value.data(), value.size());
    }
};

template <class Archive>
struct Reader {
    Archive& archive;
    const InputBuffer& input;

    template <class T>
    void number(T& value)
    {
        archive >> value;
    }
    std::uint8_t small(int count, const char* kind)
    {
        std::uint8_t value = 0;
        number(value);
        if (value >= count) throw Damage(fmt::format("{} is not a {}", value, kind));
        return value;
    }
    void flag(bool& value) { value = small(2, "yes or no") == 1; }
    template <class E>
    void choice(E& value, int count)
    {
        value = static_cast<E>(small(count, "known kind"));
    }
    void text(std::string& value)
    {
        const std::uint64_t size = count(max_text, 1);
        value.resize(size);
        if (size > 0) archive.load_binary(value.data(), size);
    }
    /// A count of things that take at least `bytes` each in the archive.
    std::uint64_t count(std::uint64_t limit, std::uint64_t bytes)
    {
        std::uint64_t value = 0;
        number(value);
        if (value > limit) throw Damage(fmt::format("a count of {}, at most {} are allowed", value, limit));
        if (value > input.remaining() / bytes) {
            throw Damage(fmt::format("a count of {}, but only {} bytes follow", value, input.remaining()));
        }
        return value;
    }
};

/// Fewest bytes that an element can take: all its texts empty.
struct Sizer {
    std::uint64_t bytes = 0;

    template <class T>
    void number(const T&)
    {
        bytes += sizeof(T);
    }
    void flag(bool) { ++bytes; }
    template <class E>
    void choice(const E&, int)
    {
        ++bytes;
    }
    void text(const std::string&) { bytes += sizeof(std::uint64_t); }
};

template <class T>
std::uint64_t smallest_size()
{
    Sizer sizer;
    const T element{};
    fields(sizer, element);
    return sizer.bytes;
}

constexpr int table_version = 1;

void require_version(unsigned version)
{
    // Boost itself refuses newer ones. Tables of older versions would be read where this is called.
    if (version != table_version) {
        throw Damage(fmt::format("a table of version {}, this program reads {}", version, table_version));
    }
}

/// A vector, seen by Boost as one object with a version.
template <class T>
struct Vector {
    std::vector<T>* items;
    std::uint64_t limit;
    const InputBuffer* input = nullptr;

    template <class Archive>
    void save(Archive& archive, unsigned) const
    {
        Writer<Archive> writer{archive};
        writer.number(static_cast<std::uint64_t>(items->size()));
        for (const T& item : *items) fields(writer, item);
    }
    template <class Archive>
    void load(Archive& archive, unsigned version)
    {
        require_version(version);
        Reader<Archive> reader{archive, *input};
        items->resize(reader.count(limit, smallest_size<T>()));
        for (T& item : *items) fields(reader, item);
    }
    BOOST_SERIALIZATION_SPLIT_MEMBER()
};

/// The whole scene; `input` is there when reading.
struct Root {
    Scene* scene;
    const InputBuffer* input = nullptr;

    template <class Io>
    void scalars(Io& io) const
    {
        io.text(scene->source);
        io.number(scene->vertex_count);
        io.number(scene->index_count);
        fields(io, scene->bounds);
    }
    template <class Do>
    void vectors(Do&& table) const
    {
        table(Vector<Material>{&scene->materials, max_materials, input});
        table(Vector<Texture>{&scene->textures, max_textures, input});
        table(Vector<Mesh>{&scene->meshes, max_meshes, input});
        table(Vector<Cluster>{&scene->clusters, max_clusters, input});
        table(Vector<BakeWarning>{&scene->warnings, max_warnings, input});
    }
    template <class Archive>
    void save(Archive& archive, unsigned) const
    {
        Writer<Archive> writer{archive};
        scalars(writer);
        vectors([&](const auto& table) { archive << table; });
    }
    template <class Archive>
    void load(Archive& archive, unsigned version)
    {
        require_version(version);
        Reader<Archive> reader{archive, *input};
        scalars(reader);
        vectors([&](auto table) { archive >> table; });
    }
    BOOST_SERIALIZATION_SPLIT_MEMBER()
};

/// The archive begins with Boost's signature, a string. Boost reads it with the loading that makes room for any count,
/// so it is looked at here before Boost sees it.
void require_signature(std::span<const std::byte> archive)
{
    const std::string_view signature = boost::archive::BOOST_ARCHIVE_SIGNATURE();
    std::uint64_t size = 0;
    if (archive.size() >= sizeof(size) + signature.size()) std::memcpy(&size, archive.data(), sizeof(size));
    if (size != signature.size() ||
        std::memcmp(archive.data() + sizeof(size), signature.data(), signature.size()) != 0) {
        throw Damage("it does not begin as an archive of Boost.Serialization does");
    }
}

} // namespace
} // namespace atrium::bake

BOOST_CLASS_VERSION(atrium::bake::Root, atrium::bake::table_version)
BOOST_CLASS_VERSION(atrium::bake::Vector<atrium::Material>, atrium::bake::table_version)
BOOST_CLASS_VERSION(atrium::bake::Vector<atrium::Texture>, atrium::bake::table_version)
BOOST_CLASS_VERSION(atrium::bake::Vector<atrium::Mesh>, atrium::bake::table_version)
BOOST_CLASS_VERSION(atrium::bake::Vector<atrium::Cluster>, atrium::bake::table_version)
BOOST_CLASS_VERSION(atrium::bake::Vector<atrium::BakeWarning>, atrium::bake::table_version)
BOOST_CLASS_TRACKING(atrium::bake::Root, boost::serialization::track_never)
BOOST_CLASS_TRACKING(atrium::bake::Vector<atrium::Material>, boost::serialization::track_never)
BOOST_CLASS_TRACKING(atrium::bake::Vector<atrium::Texture>, boost::serialization::track_never)
BOOST_CLASS_TRACKING(atrium::bake::Vector<atrium::Mesh>, boost::serialization::track_never)
BOOST_CLASS_TRACKING(atrium::bake::Vector<atrium::Cluster>, boost::serialization::track_never)
BOOST_CLASS_TRACKING(atrium::bake::Vector<atrium::BakeWarning>, boost::serialization::track_never)

namespace atrium::bake {

std::string encode_archive(const Scene& scene)
{
    std::stringbuf buffer(std::ios::out | std::ios::binary);
    {
        boost::archive::binary_oarchive archive(buffer, boost::archive::no_codecvt);
        const Root root{const_cast<Scene*>(&scene)}; // NOLINT: saving only reads it
        archive << root;
    }
    return buffer.str();
}

Scene decode_archive(std::span<const std::byte> bytes, const std::string& name)
{
    Scene scene;
    InputBuffer input(bytes);
    try {
        require_signature(bytes);
        boost::archive::binary_iarchive archive(input, boost::archive::no_codecvt);
        Root root{&scene, &input};
        archive >> root;
        if (input.remaining() != 0) throw Damage(fmt::format("{} bytes follow the scene", input.remaining()));
    } catch (const boost::archive::archive_exception& e) {
        refuse(name, "section archive",
               fmt::format("byte {} of {}: Boost.Serialization says: {}", input.position(), bytes.size(), e.what()));
    } catch (const Damage& e) {
        refuse(name, "section archive", fmt::format("byte {} of {}: {}", input.position(), bytes.size(), e.what()));
    }
    return scene;
}

} // namespace atrium::bake
