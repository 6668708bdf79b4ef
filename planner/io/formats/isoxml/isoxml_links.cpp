#include "planner/io/formats/isoxml/isoxml_links.h"

#include "planner/core/text.h"
#include "planner/geodesy/local_frame.h"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <format>
#include <sstream>

namespace furrow {

namespace {

// LGP B: the links are UUIDs.
constexpr std::string_view kUuids = "1";

bool isUuid(std::string_view text) {
    constexpr std::string_view kShape = "hhhhhhhh-hhhh-hhhh-hhhh-hhhhhhhhhhhh";
    return text.size() == kShape.size() && std::ranges::equal(text, kShape, [](char letter, char shape) {
               const bool digit = (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
               return shape == 'h' ? digit : letter == shape;
           });
}

/// Without its braces, in small letters.
std::string bare(std::string_view text) {
    if (text.starts_with('{') && text.ends_with('}')) {
        text = text.substr(1, text.size() - 2);
    }
    return inSmallLetters(text);
}

/// FNV-1a (Fowler, Noll, Vo) of 64 bits, each bit then spread over all (the finaliser of MurmurHash3).
std::uint64_t hashed(std::string_view text, std::uint64_t seed) {
    std::uint64_t hash = 0xcbf29ce484222325ULL ^ seed;
    for (const char byte : text) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
    }
    hash = (hash ^ (hash >> 33U)) * 0xff51afd7ed558ccdULL;
    hash = (hash ^ (hash >> 33U)) * 0xc4ceb9fe1a85ec53ULL;
    return hash ^ (hash >> 33U);
}

}  // namespace

std::string fieldUuid(const FieldSource& field) {
    if (const std::string id = bare(field.id); isUuid(id)) {
        return id;
    }
    const GeoPoint middle = middleOf(field.parts);
    const std::string text = std::format("{}\n{}\n{:.0f}\n{:.0f}", field.id, field.name,
                                         middle.lonDeg * 100.0, middle.latDeg * 100.0);
    const std::uint64_t high = hashed(text, 0);
    const std::uint64_t low = hashed(text, 0x9e3779b97f4a7c15ULL);
    return std::format("{:08x}-{:04x}-8{:03x}-{:04x}-{:012x}", high >> 32U, (high >> 16U) & 0xFFFFU,
                       high & 0xFFFU, 0x8000U | ((low >> 48U) & 0x3FFFU), low & 0xFFFFFFFFFFFFULL);
}

std::string isoxmlLinkList(std::span<const FieldContent> fields) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node root = document.append_child("ISO11783LinkList");
    root.append_attribute("VersionMajor") = "4";
    root.append_attribute("VersionMinor") = "3";
    root.append_attribute("ManagementSoftwareManufacturer") = "Furrow";
    root.append_attribute("ManagementSoftwareVersion") = FURROW_VERSION;
    root.append_attribute("DataTransferOrigin") = "1";
    pugi::xml_node group = root.append_child("LGP");
    group.append_attribute("A") = "LGP1";
    group.append_attribute("B") = kUuids.data();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        pugi::xml_node link = group.append_child("LNK");
        link.append_attribute("A") = std::format("PFD{}", i + 1).c_str();
        link.append_attribute("B") = std::format("{{{}}}", fieldUuid(fields[i].field)).c_str();
    }
    std::ostringstream out;
    document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
    return std::move(out).str();
}

std::map<std::string, std::string> isoxmlLinks(std::string_view xml) {
    std::map<std::string, std::string> links;
    pugi::xml_document document;
    if (!document.load_buffer(xml.data(), xml.size())) {
        return links;
    }
    for (const pugi::xml_node group : document.child("ISO11783LinkList").children("LGP")) {
        if (std::string_view{group.attribute("B").value()} != kUuids) {
            continue;
        }
        for (const pugi::xml_node link : group.children("LNK")) {
            if (std::string uuid = bare(link.attribute("B").value()); isUuid(uuid)) {
                links.emplace(link.attribute("A").value(), std::move(uuid));
            }
        }
    }
    return links;
}

}  // namespace furrow
