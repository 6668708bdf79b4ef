#pragma once

#include "planner/core/result.h"
#include "planner/project/project.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// One change and the project after it.
struct HistoryStep {
    std::string text;  ///< as people see it: "Move a point"
    std::shared_ptr<const Project> after;
};

/// What was done to a project, and how far of it is undone.
struct History {
    std::shared_ptr<const Project> base;  ///< before the first step
    std::vector<HistoryStep> steps;
    std::size_t done = 0;  ///< steps that are not undone

    /// Where the project file lies; empty where it was never saved.
    std::filesystem::path file;
    /// Of the project file as it was saved or read last; empty for none.
    std::string savedFingerprint;
    /// Steps that were done then; nothing where that state is no longer among these.
    std::optional<std::size_t> saved;

    std::shared_ptr<const Project> current() const { return done == 0 ? base : steps[done - 1].after; }
    /// Something was changed since it was saved.
    bool isUnsaved() const { return saved != done; }
};

/// Takes what is in the project file as saved where it is one of the history's states, the latest of them: a
/// crash may come between saving and noting it. False where the file is another program's.
bool recogniseSaved(History& history, const Project& inFile, const std::string& fingerprint);

/// Keeps a history in a file while it is made, so that nothing is lost when the program or the computer
/// stops. Changes are appended; what a crash cut off is dropped when it is read. While it is open nobody else
/// can open it.
class HistoryJournal {
public:
    /// Opens or makes the file. Usage: another program has it open. WriteFailed.
    static Result<HistoryJournal> open(const std::filesystem::path& path);
    ~HistoryJournal();
    HistoryJournal(HistoryJournal&& other) noexcept;
    HistoryJournal& operator=(HistoryJournal&& other) noexcept;

    const std::filesystem::path& path() const { return path_; }
    /// What the file holds, the last kMostSteps of it; nothing where it is empty or its beginning is damaged.
    std::optional<History> read() const;

    /// Brings the file to this history: appends what differs from what was written last and syncs it. Steps
    /// that are the same are told by their pointer. Writes the file anew where it has grown too large or
    /// another history begins. WriteFailed.
    Result<void> write(const History& history);
    /// Deletes the file.
    void remove();

    static constexpr std::size_t kLargestBytes = std::size_t{64} << 20;
    static constexpr std::size_t kMostSteps = 200;

private:
    HistoryJournal(std::filesystem::path path, int file) : path_{std::move(path)}, file_{file} {}
    Result<void> append(const std::string& text);
    Result<void> rewrite(const History& history);
    std::string lineOfRest(const History& history) const;

    std::filesystem::path path_;
    int file_ = -1;
    /// As it is in the file; no base while nothing was written.
    History written_;
    std::size_t bytes_ = 0;
    std::size_t bytesAtRewrite_ = 0;
};

}  // namespace furrow
