# Writes the bytes of INPUT as a function of OUTPUT. A string literal compiles many times faster
# than a list of numbers.
file(READ "${INPUT}" bytes HEX)
string(REPEAT "." 64 line)
string(REGEX REPLACE "(${line})" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
string(REPLACE "\n" "\"\n\"" bytes "${bytes}")
file(WRITE "${OUTPUT}" "#include \"base/embedded.h\"
namespace versorium::embedded_files {
static const char kBytes_${SYMBOL}[] =
\"${bytes}\";
std::span<const unsigned char> file_${SYMBOL}();
std::span<const unsigned char> file_${SYMBOL}() {
    return {reinterpret_cast<const unsigned char*>(kBytes_${SYMBOL}), sizeof kBytes_${SYMBOL} - 1};
}
}  // namespace versorium::embedded_files
")
