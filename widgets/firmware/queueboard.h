// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/leastheight.h"
#include "widgets/common/selection.h"
#include "widgets/common/visitarchive.h"
#include "widgets/common/workbench.h"
#include "widgets/firmware/queuelines.h"
#include "widgets/firmware/queuerecipe.h"

#include <map>

class QLabel;
class QTableView;

namespace mb {

class Banner;
class QueueBar;
class QueueChecks;
class QueueHead;
class QueueModel;
class QueueSide;
class QueueTable;
class UnitSteps;
class UpdateLog;

/// Many units by one order: what is done to each, which are ticked, how far each is, what was said, and what can be ordered
/// of the whole and of one. GUI thread.
class QueueBoard : public LeastHeight {
    Q_OBJECT
public:
    QueueBoard(Workbench &workbench, Selection &selection, std::span<const Family *const> families,
        const ThemeSource &theme, QWidget *parent);

    /// Where recipes are kept: the folder of the project, empty without one.
    void setRecipeFolder(const QString &folder) { m_recipeFolder = folder; }
    /// False, with a notice of what is wrong, where it is none.
    bool openImage(const QString &path);
    bool openRecipe(const QString &path) { return opened(m_recipe.openRecipe(path, m_families)); }
    /// Opens the editor with the recipe that is open, or with a new one; what is saved there is opened here.
    void edit();
    /// The ticked units; nothing while canStart() is false.
    void start();
    [[nodiscard]] bool canStart() const { return hindrance().isEmpty(); }
    /// Goes on with what was cut off; nothing while mayGoOn() is false.
    void goOn();
    /// Whether the journal is known to have a queue of this recipe that was cut off; it is asked after each queue.
    [[nodiscard]] bool mayGoOn() const;
    [[nodiscard]] QueueModel &model() const;
    [[nodiscard]] QTableView &table() const;
    [[nodiscard]] QueueBar &bar() const { return *m_bar; }
    [[nodiscard]] UnitSteps &steps() const;
    [[nodiscard]] UpdateLog &log() const { return *m_log; }
    /// Writes what has ended into a table.
    void save(const QString &path);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void placeOrders(bool first);
    void buildBody();
    void buildFoot();
    void connectAll();
    bool opened(const Result<void> &result);
    void begin(std::vector<DeviceId> chosen, const std::string &run);
    void lookForCut();
    void askSave();
    void follow();
    void followRecipe();
    void followLog();
    void followUnit();
    [[nodiscard]] const service::QueueRow *shownRow() const;
    [[nodiscard]] QString hindrance() const;

    Workbench &m_workbench;
    Selection &m_selection;
    std::span<const Family *const> m_families;
    const ThemeSource &m_theme;
    QueueRecipe m_recipe; ///< for the next queue
    QueueRecipe m_shown;  ///< of the one that runs, which keeps what it began with; else the same
    QString m_recipeFolder;
    CutRun m_cut;
    std::string m_dismissed; ///< a run that nobody wants to go on with
    QueueHead *m_head = nullptr;
    QueueChecks *m_checks = nullptr;
    Banner *m_banner = nullptr;
    QueueBar *m_bar = nullptr;
    QWidget *m_orders = nullptr; ///< that bar and its line
    QueueTable *m_table = nullptr;
    UpdateLog *m_log = nullptr;
    QueueSide *m_side = nullptr;
    QLabel *m_foot = nullptr;
    std::map<std::uint32_t, std::size_t> m_told; ///< lines of the log, by row of the queue
};

} // namespace mb
