// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicequeue.h"

#include <QObject>

#include <memory>

namespace mb {

/// Where the journal is kept, and how far that has got. A value.
struct JournalState {
    std::string server;  ///< address that stations share; empty: this computer's file alone
    std::string station; ///< name of this one in it
    int waiting = 0;     ///< entries that the server has not got
    Message trouble;     ///< why it did not take them; empty: it did

    friend bool operator==(const JournalState &, const JournalState &) = default;
};

/// A queue of units that is served, as the window sees it at one moment. A value.
struct ServiceView {
    bool running = false;   ///< units are served, or waited for
    bool pausing = false;   ///< after this unit
    bool moves = false;     ///< the recipe has a self-test: it can be armed while it runs
    bool armed = false;     ///< self-tests may turn the motor
    Instant armedUntil{};   ///< without a unit until then
    bool announces = false; ///< a motor turns within three seconds
    bool waits = false;     ///< a unit waits for its self-test until the station is armed
    std::vector<std::string> links;
    std::string recipe;                  ///< its name
    std::string run;                     ///< to be gone on with; empty: nothing has begun
    Message trouble;                     ///< what ended it before its time
    std::vector<service::QueueRow> rows; ///< in the order in which units were found
    service::QueueCounts counts;
};

/// The door between the window and the service of units: orders go in, views come out, nothing waits. Everything on the GUI
/// thread. The program's is app/servicedoor.
class ServiceDesk : public QObject {
    Q_OBJECT
public:
    using Finished = std::function<void(Result<void>)>;
    struct Plan {
        std::shared_ptr<const service::RecipeMatter> matter;
        std::vector<std::string> links; ///< addresses; they are open
        std::optional<int> units;       ///< as QueueOptions::units
        /// Nothing: every unit of the family. Else these only, and those that the run has cut off; the others are left out.
        std::optional<std::vector<DeviceId>> chosen{};
        std::string run{}; ///< as QueueOptions::run
    };
    /// A run that was cut off, as the journal has it.
    struct CutRun {
        std::string run; ///< empty: there is none
        int ended = 0;   ///< units that have their verdict
        int open = 0;    ///< units that were being served
    };
    using CutFound = std::function<void(Result<CutRun>)>;
    using Listed = std::function<void(Result<std::vector<service::Visit>>)>;
    using QObject::QObject;

    /// Where recipes are kept: the folder of the project, empty without one.
    [[nodiscard]] const QString &recipeFolder() const { return m_recipeFolder; }
    void setRecipeFolder(const QString &folder) { m_recipeFolder = folder; }

    [[nodiscard]] virtual const ServiceView &view() const = 0;
    /// Serves the units of these links, which nobody else uses meanwhile. Refused while another queue runs.
    virtual void begin(const Plan &plan, Finished finished) = 0;
    /// The last run of this recipe, where units of it were cut off and nobody has gone on since.
    virtual void findCut(const service::RecipeMatter &matter, CutFound found) = 0;
    /// After this unit; or goes on.
    virtual void pause(bool on) = 0;
    virtual void skip(std::uint32_t row) = 0;
    /// One that failed, was refused or was left out, once more.
    virtual void retry(std::uint32_t row) = 0;
    virtual void retryFailed() = 0;
    /// No more units; ends when those that run have ended.
    virtual void finish() = 0;
    /// No more units; those that run end as soon as nothing must not be cut, and stay open in the journal.
    virtual void cancel() = 0;
    /// Self-tests may turn the motors of this recipe on this link, until it is stopped, fails, is left, has no unit for five
    /// minutes, or this takes it back.
    virtual void arm(bool on) = 0;
    /// The window is alive: ten times a second, while a motor may turn.
    virtual void renew() = 0;

    [[nodiscard]] virtual const JournalState &journal() const = 0;
    /// From now on under the name of `station`, and shared on `server` (`postgresql://USER@HOST/DB`; empty: not shared). Empty
    /// `station`: the computer's name. Usage for another address; Unsafe while units are served.
    virtual void keepJournal(const std::string &server, const std::string &station, Finished finished) = 0;

    /// What the journal has, oldest first.
    virtual void list(const service::VisitFilter &filter, Listed listed) = 0;
    /// A note of the operator on an entry.
    virtual void setNote(const std::string &visit, const QString &note, Finished finished) = 0;
    /// A table of them with everything the journal knows.
    virtual void exportTo(const QString &path, std::vector<service::Visit> visits, Finished finished) = 0;

Q_SIGNALS:
    void changed();
    /// keepJournal() was done, to be remembered for the next start.
    void journalKept(const QString &server, const QString &station);
    /// Its row is in the journal.
    void unitEnded(const mb::service::Visit &visit);

private:
    QString m_recipeFolder;
};

} // namespace mb
