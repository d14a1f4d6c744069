// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/message.h"

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace mb::guardian {

/// A stop that could not be sent, or was not confirmed.
struct Debt {
    std::string name; ///< of the device
    Script script;
    std::chrono::milliseconds since{}; ///< runTime() then; in the future: of an earlier run of the machine
};

/// Since this run of the machine began, asleep or not: of every process the same, and nobody sets it.
[[nodiscard]] std::chrono::milliseconds runTime();

/// "abstractdc:3" of "socketcan:can0/abstractdc:3": a line may have another name by now.
[[nodiscard]] std::string_view unitOf(std::string_view name);

/// What is owed on one line, kept where every guardian and every program of this user finds it, and the lock that says whose
/// business the line is. Whoever has the lock pays: a program as long as it has the link open and lives, else a guardian while it
/// tries. A lock goes with its process, however that ends.
class DebtBook {
public:
    /// `line` is the identity of a link; the folder is made when it is needed.
    DebtBook(std::string folder, std::string_view line);
    DebtBook(const DebtBook &) = delete;
    DebtBook &operator=(const DebtBook &) = delete;
    ~DebtBook();

    enum class Claim {
        Mine,
        Others,   ///< another process has the lock
        Unusable, ///< there is no lock to be had, and nothing can be written down
    };
    /// Takes the lock without waiting; Mine also when it is held already.
    [[nodiscard]] Claim claim();
    bool own() { return claim() == Claim::Mine; }
    void disown();
    [[nodiscard]] const std::string &folder() const { return m_folder; }
    /// Something is owed. Cheap.
    [[nodiscard]] bool exists() const;
    /// What was owed was confirmed or settled; false where the book itself is gone, or never was.
    [[nodiscard]] bool isSettled() const;
    [[nodiscard]] std::vector<Debt> read() const;
    /// One of the same unit is replaced. False when it cannot be kept.
    bool add(const Debt &debt);
    void remove(std::string_view name);

private:
    /// Reads, changes and writes, no other process in between.
    bool change(const std::function<void(std::vector<Debt> &)> &with) const;
    [[nodiscard]] bool write(const std::vector<Debt> &debts) const;

    std::string m_folder;
    std::string m_path;
    int m_lock = -1;
};

/// Of this user and this run of the machine: below XDG_RUNTIME_DIR where that is this user's, or a private folder for temporary files.
[[nodiscard]] std::string debtFolder();

} // namespace mb::guardian
