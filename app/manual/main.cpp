// Writes manual pages and completions into a folder: write-manual FOLDER.

#include "app/manual/program.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <print>

namespace {

using namespace furrow::manual;
namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream stream;
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    stream.open(file, std::ios::binary);
    stream << text;
}

/// A program has a page, and so has each of its commands.
void writePages(const fs::path& folder, const Program& program, const std::vector<std::string>& others) {
    std::vector<std::string> pages = others;
    for (const Program& command : program.commands) {
        pages.push_back(program.name + "-" + std::string{command.ownName()});
        write(folder / (pages.back() + ".1"), manualPage(command, std::vector{program.name}));
    }
    write(folder / (program.name + ".1"), manualPage(program, pages));
}

void writeCompletions(const fs::path& folder, const Program& program) {
    write(folder / "bash" / program.name, bashCompletion(program));
    write(folder / "zsh" / ("_" + program.name), zshCompletion(program));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::println(stderr, "usage: write-manual FOLDER");
        return 2;
    }
    try {
        const fs::path folder{argv[1]};
        const Program window = windowProgram();
        const Program commandLine = commandLineProgram();
        writePages(folder / "man1", window, {commandLine.name});
        writePages(folder / "man1", commandLine, {window.name});
        writeCompletions(folder, window);
        writeCompletions(folder, commandLine);
    } catch (const std::exception& error) {
        std::println(stderr, "write-manual: {}", error.what());
        return 1;
    }
    return 0;
}
