// SPDX-License-Identifier: MIT
#include "settings.h"

#include <cstdlib>
#include <filesystem>

#include "io/files.h"

namespace versorium {

namespace fs = std::filesystem;

std::string settingsFolder() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    if (config && config[0] == '/') return std::string(config) + "/versorium";
    const char* home = std::getenv("HOME");
    if (home && home[0] == '/') return std::string(home) + "/.config/versorium";
    return {};
}

std::string readSetting(const std::string& name) {
    const std::string folder = settingsFolder();
    if (folder.empty()) return {};
    const Expected<Bytes> bytes = readFile(folder + "/" + name, std::size_t{1} << 20);
    std::string text = bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    return text;
}

Status writeSetting(const std::string& name, const std::string& text) {
    const std::string folder = settingsFolder();
    if (folder.empty())
        return Status::inputOutput("there is no folder for settings: set HOME or XDG_CONFIG_HOME");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return Status::inputOutput(folder + ": " + error.message());
    return writeFileAtomically(folder + "/" + name, text);
}

std::string freePath(const std::string& name) {
    const fs::path path(name);
    std::error_code error;
    std::string candidate = fs::absolute(path, error).string();
    for (int k = 2; fs::exists(candidate, error); ++k)
        candidate =
            fs::absolute(path.stem().string() + "-" + std::to_string(k) + path.extension().string(),
                         error)
                .string();
    return candidate;
}

}  // namespace versorium
