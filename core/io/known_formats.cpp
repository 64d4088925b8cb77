// SPDX-License-Identifier: MIT
#include "io/known_formats.h"

#include "io/text_scanner.h"

namespace versorium {
namespace {

using namespace std::string_view_literals;

struct Magic {
    std::string_view start;
    const char* name;
};

constexpr Magic kMagics[] = {
    {"GIF8"sv, "a GIF picture"},
    {"II*\0"sv, "a TIFF picture"},
    {"MM\0*"sv, "a TIFF picture"},
    {"8BPS"sv, "a Photoshop picture (PSD)"},
    {"v/1\x01"sv, "an OpenEXR picture"},
    {"#?RADIANCE"sv, "a Radiance picture (HDR)"},
    {"qoif"sv, "a QOI picture"},
    {"\xff\x0a"sv, "a JPEG XL picture"},
    {"\0\0\0\x0cJXL "sv, "a JPEG XL picture"},
    {"\0\0\0\x0cjP  "sv, "a JPEG 2000 picture"},
    {"gimp xcf"sv, "a GIMP picture (XCF)"},
    {"%PDF"sv, "a PDF document"},
    {"%!PS"sv, "a PostScript file"},
    {"PK\x03\x04"sv, "a ZIP archive, or a file that is one inside (3MF, DOCX, ODT)"},
    {"\x1f\x8b"sv, "a gzip archive"},
    {"7z\xbc\xaf"sv, "a 7-Zip archive"},
    {"glTF"sv, "a glTF file"},
    {"Kaydara FBX"sv, "an FBX file"},
    {"; FBX"sv, "an FBX file"},
    {"BLENDER"sv, "a Blender file"},
    {"ISO-10303-21"sv, "a STEP file"},
    {"#VRML"sv, "a VRML file"},
    {"#X3D"sv, "an X3D file"},
    {"OFF\n"sv, "an OFF mesh"},
    {"OFF\r"sv, "an OFF mesh"},
    {"COFF"sv, "an OFF mesh"},
    {"NOFF"sv, "an OFF mesh"},
    {"\x93NUMPY"sv, "a NumPy array"},
    {"\x89HDF"sv, "an HDF5 file"},
    {"SIMPLE  ="sv, "a FITS picture"},
    {"RIFF"sv, "a RIFF file (WAV or AVI)"},
    {"\x1a\x45\xdf\xa3"sv, "a Matroska or WebM film"},
    {"OggS"sv, "an Ogg file"},
};

// What XML holds, by the first element that is known.
std::string xmlFormat(std::string_view text) {
    const std::string start = lowered(text.substr(0, 4096));
    constexpr Magic kElements[] = {
        {"<svg"sv, "an SVG drawing"}, {"<collada"sv, "a COLLADA file"},
        {"<x3d"sv, "an X3D file"},    {"<amf"sv, "an AMF file"},
        {"<vtkfile"sv, "a VTK file"}, {"<flame"sv, "a flame of Apophysis or flam3"},
        {"<gpx"sv, "a GPX track"},    {"<!doctype html"sv, "a web page"},
        {"<html"sv, "a web page"}};
    for (const Magic& element : kElements)
        if (start.find(element.start) != std::string::npos) return element.name;
    return start.starts_with("<?xml") ? "an XML file" : "";
}

// The box "ftyp" of ISO media files names its brand.
std::string isoFormat(std::string_view text) {
    const std::string_view brand = text.substr(8, 4);
    if (brand == "avif" || brand == "avis") return "an AVIF picture";
    for (const std::string_view known : {"heic"sv, "heix"sv, "mif1"sv, "msf1"sv, "hevc"sv})
        if (brand == known) return "a HEIC picture";
    return "an MP4 or QuickTime film";
}

}  // namespace

bool isPng(std::span<const unsigned char> bytes) { return textOf(bytes).starts_with("\x89PNG"sv); }

bool looksLikePicture(std::span<const unsigned char> bytes) {
    const std::string_view text = textOf(bytes);
    if (isPng(bytes) || text.starts_with("\xff\xd8\xff"sv)) return true;
    // BM, and the length of the header that follows that of the file.
    if (!text.starts_with("BM"sv) || bytes.size() < 26) return false;
    for (const int length : {12, 16, 40, 52, 56, 64, 108, 124})
        if (bytes[14] == length && bytes[15] == 0 && bytes[16] == 0 && bytes[17] == 0) return true;
    return false;
}

std::string foreignFormat(std::span<const unsigned char> bytes) {
    const std::string_view text = textOf(bytes);
    if (text.size() >= 12 && text.starts_with("RIFF"sv) && text.substr(8, 4) == "WEBP"sv)
        return "a WebP picture";
    if (text.size() >= 12 && text.substr(4, 4) == "ftyp"sv) return isoFormat(text);
    for (const Magic& magic : kMagics)
        if (text.starts_with(magic.start)) return magic.name;
    std::string_view first = withoutMark(text);
    while (!first.empty() && " \t\r\n"sv.find(first.front()) != std::string_view::npos)
        first.remove_prefix(1);
    if (first.starts_with("<"sv)) return xmlFormat(first);
    // A glTF file that is text.
    if (first.starts_with("{"sv) && first.substr(0, 4096).find("\"asset\"") != first.npos &&
        first.find("\"bufferViews\"") != first.npos)
        return "a glTF file";
    return {};
}

Status foreignFault(std::span<const unsigned char> bytes) {
    const std::string format = foreignFormat(bytes);
    if (format.empty()) return {};
    std::string advice = "; no command reads it";
    const auto has = [&](std::string_view word) { return format.find(word) != std::string::npos; };
    if (has("picture") || has("drawing")) advice = "; save it as PNG";
    if (has("archive")) advice = "; unpack it first";
    for (const std::string_view mesh : {"glTF"sv, "FBX"sv, "Blender"sv, "STEP"sv, "VRML"sv, "X3D"sv,
                                        "OFF"sv, "COLLADA"sv, "AMF"sv, "VTK"sv})
        if (has(mesh)) advice = "; export the mesh as OBJ, PLY or STL";
    return Status::data("this is " + format + ", which is not read here" + advice);
}

bool hasEnding(std::string_view name, std::initializer_list<std::string_view> endings) {
    for (const std::string_view ending : endings)
        if (name.size() > ending.size() &&
            lowered(name.substr(name.size() - ending.size())) == ending)
            return true;
    return false;
}

bool namesMesh(std::string_view name) { return hasEnding(name, {".obj", ".ply", ".stl"}); }
bool namesGrid(std::string_view name) { return hasEnding(name, {".f3d", ".field2d", ".grid"}); }
bool namesPicture(std::string_view name) {
    return hasEnding(name, {".png", ".jpg", ".jpeg", ".jpe", ".bmp"});
}
bool namesShapeFile(std::string_view name) {
    return namesMesh(name) || namesGrid(name) || namesPicture(name) ||
           hasEnding(name, {".gif", ".webp", ".svg", ".tif", ".tiff", ".heic", ".avif", ".psd",
                            ".gltf", ".glb", ".fbx", ".off", ".3mf", ".dae", ".blend", ".step",
                            ".stp", ".wrl", ".x3d"});
}

}  // namespace versorium
