#include "assetconv/material_rules.hpp"

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

constexpr float default_f0 = 0.04f;
constexpr float grey_default = 0.8f;
constexpr float default_ns_under_map = 100.0f;
/// Below this an alpha or a colour difference is rounding.
constexpr float visible_step = 2.5f / 255.0f;

float largest(const vec3& c)
{
    return std::max({c.x, c.y, c.z});
}

bool is_neutral(const vec3& c)
{
    return largest(c) - std::min({c.x, c.y, c.z}) < 1e-4f;
}

bool is_saturated(const vec3& c)
{
    return largest(c) > 0.1f && largest(c) - std::min({c.x, c.y, c.z}) > 0.3f * largest(c);
}

/// Without -illum a file means the full model.
int illumination(const MtlMaterial& mtl)
{
    return mtl.illum.value_or(2);
}

bool has_highlight(const MtlMaterial& mtl)
{
    return illumination(mtl) >= 2;
}

bool is_glass(const MtlMaterial& mtl)
{
    const int illum = illumination(mtl);
    return illum == 4 || illum == 6 || illum == 7 || illum == 9;
}

/// The table, one function per part of the material.
class Rules {
public:
    Rules(const MtlMaterial& mtl, const MapFiles& files, const ImageStore& images, const NormalVerdicts& verdicts,
          Warnings& warnings)
        : mtl_(mtl), files_(files), images_(images), verdicts_(verdicts), warnings_(warnings)
    {}

    MaterialPlan run()
    {
        m_.name = mtl_.name;
        opacity();
        base_color();
        metallic();
        specular_and_roughness();
        emission();
        normal();
        uv_transform();
        m_.two_sided = m_.cls == MaterialClass::masked || m_.cls == MaterialClass::blended;
        return std::move(plan_);
    }

private:
    [[nodiscard]] const SourceImage* image(MapKind kind) const
    {
        const auto& file = files_[static_cast<std::size_t>(kind)];
        return file ? images_.find(*file) : nullptr;
    }

    [[nodiscard]] MapInput input(MapKind kind, char default_channel = 'l') const
    {
        const MapReference& map = *mtl_.map(kind);
        return {*files_[static_cast<std::size_t>(kind)], map.file, map.channel != 0 ? map.channel : default_channel,
                map.base, map.gain};
    }

    /// The value of a scalar map that has only one.
    [[nodiscard]] std::optional<float> constant(MapKind kind) const
    {
        const SourceImage* i = image(kind);
        const MapInput map = input(kind);
        if (map.channel != 'l' || i->luminance_max - i->luminance_min > visible_step) return std::nullopt;
        return map.adjust(i->luminance_max);
    }

    /// What d and Tr say. Writers disagree about Tr, and about 0 and 1.
    float dissolve(bool has_mask)
    {
        const bool tr_alone = !mtl_.d && mtl_.tr;
        const float d = glm::clamp(mtl_.d.value_or(1 - mtl_.tr.value_or(0)), 0.0f, 1.0f);
        if (d > 0) return d;
        if (!has_mask && !(tr_alone && !mtl_.tf))
            warnings_.add("mtl-invisible", mtl_.where + ", \"" + mtl_.name + "\"");
        return 1;
    }

    struct Mask {
        std::optional<MapInput> map;
        float min = 1, max = 1;
    };

    /// map_d (its alpha where that varies, else its luminance), or the alpha of the colour map.
    [[nodiscard]] Mask find_mask() const
    {
        Mask mask;
        if (const SourceImage* i = image(MapKind::alpha)) {
            const bool by_alpha = i->has_alpha() && i->alpha_max - i->alpha_min > visible_step;
            mask.map = input(MapKind::alpha, by_alpha ? 'm' : 'l');
            const bool alpha = mask.map->channel == 'm';
            mask.min = mask.map->adjust(alpha ? i->alpha_min : i->luminance_min);
            mask.max = mask.map->adjust(alpha ? i->alpha_max : i->luminance_max);
        } else if (const SourceImage* c = image(base_map()); c != nullptr && c->has_alpha()) {
            mask.map = input(base_map());
            *mask.map = {mask.map->image, mask.map->name, 'm', 0, 1};
            mask.min = c->alpha_min;
            mask.max = c->alpha_max;
        }
        if (mask.min > mask.max) std::swap(mask.min, mask.max); // a negative gain
        return mask;
    }

    void opacity()
    {
        const Mask mask = find_mask();
        const bool varies = mask.map && mask.max - mask.min > visible_step;
        float d = dissolve(mask.map.has_value());
        if (mask.map && !varies && mask.max > 0) d *= mask.max; // an empty alpha channel means nothing
        const bool has_holes = varies && mask.min * d < mask_cutoff;
        const bool has_solids = mask.max * d >= mask_cutoff;
        m_.opacity = d;
        if (has_holes) {
            m_.cls = has_solids ? MaterialClass::masked : MaterialClass::blended;
            recipe(plan_.base_color, TextureRole::base_color).alpha = mask.map;
            if (has_solids) plan_.base_color->cutoff = mask_cutoff / d; // of the texture alone
        } else if (d < 0.9995f) {
            m_.cls = MaterialClass::blended;
        } else if (is_glass(mtl_) && mtl_.tf && largest(*mtl_.tf) > 0 && largest(*mtl_.tf) < 1) {
            m_.cls = MaterialClass::blended; // 0 and 1 are what exporters write for everything
            m_.opacity = std::max(0.1f, 1 - largest(*mtl_.tf));
        }
    }

    [[nodiscard]] MapKind base_map() const
    {
        return image(MapKind::diffuse) != nullptr ? MapKind::diffuse : MapKind::ambient;
    }

    void base_color()
    {
        const MapKind kind = base_map();
        const bool has_map = image(kind) != nullptr;
        const bool missing = !has_map && (mtl_.map(MapKind::diffuse) || mtl_.map(MapKind::ambient));
        vec3 kd = glm::clamp(mtl_.kd.value_or(vec3(has_map ? 1.0f : grey_default)), vec3(0), vec3(1));
        if (has_map && is_neutral(kd)) kd = vec3(1);
        if (missing && largest(kd) == 0) kd = vec3(grey_default);
        m_.base_color = kd;
        if (has_map) recipe(plan_.base_color, TextureRole::base_color).color = input(kind);
    }

    void metallic()
    {
        if (image(MapKind::metallic) != nullptr || mtl_.pm) {
            m_.metallic = glm::clamp(mtl_.pm.value_or(1), 0.0f, 1.0f);
            if (image(MapKind::metallic) == nullptr) return;
            if (const auto value = constant(MapKind::metallic))
                m_.metallic *= *value;
            else
                recipe(plan_.surface, TextureRole::surface).metallic = input(MapKind::metallic);
            return;
        }
        const vec3 ks = mtl_.ks.value_or(vec3(0));
        const bool dark = mtl_.kd && largest(*mtl_.kd) < 0.1f && !plan_.base_color && m_.cls == MaterialClass::opaque;
        if (!has_highlight(mtl_) || !dark || !(is_saturated(ks) || largest(ks) > 0.5f)) return;
        m_.metallic = 1;
        m_.base_color = glm::clamp(ks, vec3(0), vec3(1));
    }

    [[nodiscard]] float dielectric_f0() const
    {
        if (!has_highlight(mtl_)) return default_f0;
        const float ni = mtl_.ni.value_or(1);
        if (ni >= 1.1f && ni <= 2.5f) return (ni - 1) * (ni - 1) / ((ni + 1) * (ni + 1));
        const float ks = largest(mtl_.ks.value_or(vec3(0)));
        return ks > 0 ? glm::clamp(0.08f * ks, 0.02f, 0.08f) : default_f0;
    }

    void specular_and_roughness()
    {
        m_.specular = dielectric_f0();
        const bool own_roughness = mtl_.pr || image(MapKind::roughness) != nullptr;
        float ns = mtl_.ns.value_or(0);
        bool specular_map = has_highlight(mtl_) && image(MapKind::specular) != nullptr;
        bool shininess_map = has_highlight(mtl_) && !own_roughness && image(MapKind::shininess) != nullptr;
        if (shininess_map) {
            ns = mtl_.ns.value_or(default_ns_under_map);
            if (const auto value = constant(MapKind::shininess)) {
                ns *= *value;
                shininess_map = false;
            }
        }
        m_.roughness = has_highlight(mtl_) ? roughness_of_exponent(ns) : 1.0f;
        if (specular_map) {
            if (const auto value = constant(MapKind::specular)) {
                m_.specular *= *value;
                m_.roughness = roughness_under_specular_map(m_.roughness, *value);
                specular_map = false;
            }
        }
        if (specular_map) recipe(plan_.surface, TextureRole::surface).specular = input(MapKind::specular);
        if (own_roughness) return own_roughness_rule();
        if (!specular_map && !shininess_map) return;
        TextureRecipe& surface = recipe(plan_.surface, TextureRole::surface);
        if (shininess_map) surface.shininess = input(MapKind::shininess);
        surface.bake_roughness = true;
        surface.base_roughness = m_.roughness;
        surface.ns = ns;
        m_.roughness = 1;
    }

    void own_roughness_rule()
    {
        m_.roughness = glm::clamp(mtl_.pr.value_or(1), 0.0f, 1.0f);
        if (image(MapKind::roughness) == nullptr) return;
        if (const auto value = constant(MapKind::roughness))
            m_.roughness *= *value;
        else
            recipe(plan_.surface, TextureRole::surface).roughness = input(MapKind::roughness);
    }

    void emission()
    {
        const vec3 ke = glm::max(mtl_.ke.value_or(vec3(0)), vec3(0));
        m_.emission = ke;
        if (image(MapKind::emission) == nullptr) return;
        if (largest(ke) == 0) m_.emission = vec3(1); // a map that would never be seen is not what was meant
        recipe(plan_.emission, TextureRole::emission).color = input(MapKind::emission);
    }

    void normal()
    {
        for (const MapKind kind : {MapKind::normal, MapKind::bump, MapKind::displacement}) {
            if (image(kind) == nullptr) continue;
            const NormalVerdict& verdict = verdicts_.at(*files_[static_cast<std::size_t>(kind)]);
            const bool normals = verdict.content == BumpContent::normals;
            if (verdict.content == BumpContent::colour) warnings_.add("bump-colour", mtl_.map(kind)->where);
            const SourceImage& i = *image(kind);
            if (!normals && i.luminance_max - i.luminance_min <= 0) return; // no slopes
            TextureRecipe& r = recipe(plan_.normal, TextureRole::normal);
            r.color = input(kind);
            r.from_height = !normals;
            r.green_down = normals && verdict.green == GreenAxis::down;
            r.strength = mtl_.map(kind)->bump;
            return;
        }
    }

    /// One set of uvs serves all maps of a material.
    void uv_transform()
    {
        bool first = true;
        for (std::size_t k = 0; k < map_kind_count; ++k) {
            const auto& map = mtl_.maps[k];
            if (!map || image(static_cast<MapKind>(k)) == nullptr) continue;
            const UvTransform own{map->scale, map->offset};
            if (first)
                plan_.uv = own;
            else if (!(own == plan_.uv))
                warnings_.add("map-transform", map->where);
            first = false;
        }
        for (auto* r : {&plan_.base_color, &plan_.normal, &plan_.surface, &plan_.emission}) {
            if (*r) (*r)->clamp = clamps(**r);
        }
    }

    /// A texture clamps when the map that gives its size of meaning does.
    [[nodiscard]] bool clamps(const TextureRecipe& r) const
    {
        for (std::size_t k = 0; k < map_kind_count; ++k) {
            const auto& file = files_[k];
            if (!file || !mtl_.maps[k]) continue;
            for (const auto* map : {&r.color, &r.alpha, &r.specular, &r.roughness, &r.metallic, &r.shininess}) {
                if (*map && (*map)->image == *file) return mtl_.maps[k]->clamp;
            }
        }
        return false;
    }

    static TextureRecipe& recipe(std::optional<TextureRecipe>& slot, TextureRole role)
    {
        if (!slot) {
            slot.emplace();
            slot->role = role;
        }
        return *slot;
    }

    const MtlMaterial& mtl_;
    const MapFiles& files_;
    const ImageStore& images_;
    const NormalVerdicts& verdicts_;
    Warnings& warnings_;
    MaterialPlan plan_;
    Material& m_ = plan_.material;
};

} // namespace

bool is_map_wanted(const MtlMaterial& mtl, MapKind kind)
{
    switch (kind) {
    case MapKind::ambient:
        return !mtl.map(MapKind::diffuse);
    case MapKind::specular:
        return has_highlight(mtl);
    case MapKind::shininess:
        return has_highlight(mtl) && !mtl.pr && !mtl.map(MapKind::roughness);
    case MapKind::bump:
        return !mtl.map(MapKind::normal);
    case MapKind::displacement:
        return !mtl.map(MapKind::normal) && !mtl.map(MapKind::bump);
    default:
        return true;
    }
}

bool is_color_map(MapKind kind)
{
    return kind == MapKind::diffuse || kind == MapKind::ambient || kind == MapKind::emission;
}

MaterialPlan plan_material(const MtlMaterial& mtl, const MapFiles& files, const ImageStore& images,
                           const NormalVerdicts& verdicts, Warnings& warnings)
{
    return Rules(mtl, files, images, verdicts, warnings).run();
}

Material default_material()
{
    Material m;
    m.name = "default";
    m.base_color = vec3(grey_default);
    return m;
}

} // namespace atrium
