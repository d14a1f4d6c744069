// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/parameters/editdesk.h"
#include "widgets/parameters/parameterview.h"
#include "widgets/parameters/ramledger.h"

#include <QWidget>

#include <map>
#include <memory>
#include <set>

class QBoxLayout;
class QComboBox;
class QSplitter;
class QStackedWidget;

namespace mb {

class BannerStack;
class ChangesPanel;
class CommandButton;
class EmptyState;
class HistoryPanel;
class IconButton;
class ParameterFoot;
class ReadStatus;
class SearchField;
class Segmented;

/// The parameters of the selected device: read, edit, stage, write, prove; files in and out. Nothing is written but by
/// Write. Without a device a file can be looked at and compared.
class ParametersPage : public QWidget {
    Q_OBJECT
public:
    /// Notices of the page stand in `banners`.
    ParametersPage(
        Workbench &workbench, Selection &selection, const ThemeSource &theme, BannerStack &banners, QWidget *parent);
    ~ParametersPage() override;

    [[nodiscard]] ParameterModel &model() { return *m_model; }
    [[nodiscard]] ParameterView &view() { return *m_view; }
    [[nodiscard]] HistoryPanel &history() { return *m_history; }

    void readAll();
    /// Sends what is staged, ticked and legal, in the order of the panel.
    void write();
    void store();
    /// Stages what differs from the file; another family's file is refused.
    void importFrom(const QString &path);
    void exportTo(const QString &path);
    /// Shows the values of the file in the column of defaults.
    void compareWith(const QString &path);
    /// Without a device: shows the file itself.
    void openFile(const QString &path);
    /// What the unit has had, instead of the table.
    void showHistory(bool on);
    void takeSnapshot();
    /// The last edit; where none is staged, the last write to the unit, by a new one.
    void undo(bool redo);

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *buildHead();
    QWidget *buildTools();
    QWidget *buildTable();
    void buildEmpty();
    void buildKeys();
    void follow();
    void followEdits();
    void choose();
    void showDevice(const DeviceView &device);
    void showEmpty();
    void refresh();
    void refreshTexts();
    void readOnce(const DeviceView &device);
    void rememberAsFound(const DeviceView &device);
    void fillComparisons();
    // parameterspageaxes.cpp
    void buildAxes(QWidget &tools);
    void followAxes(const Family &family);
    void axisChosen(int place);
    void copyFrom(int axis);
    void fillCopyMenu();
    [[nodiscard]] std::optional<int> filterAxis() const;
    void comparisonChosen(int row);
    void setFilter();
    // parameterspagehistory.cpp
    void buildHistory(QWidget &content, QBoxLayout &column);
    void undoWrite(bool again);
    void restore(const QString &from);
    void act(const QString &key);
    void refuse(const char *key, DeviceId device, const QString &cause, const QString &remedy);
    void written(DeviceId device, const std::vector<ParameterChange> &sent, const Result<void> &result);
    [[nodiscard]] const DeviceView *device() const;
    [[nodiscard]] StagedEdits &editsOf(const DeviceView &device) { return m_desk.editsOf(device); }

    Workbench &m_workbench;
    EditDesk &m_desk;
    Selection &m_selection;
    const ThemeSource &m_theme;
    BannerStack &m_banners;
    RamLedger m_ledger;
    /// What the page showed last of a device; the same again needs no work.
    struct Shown {
        DeviceId device;
        std::uint64_t revision = 0;
        bool heard = false;
        DeviceState state = DeviceState::Online;
        OperationId operation;
        OperationStatus::State operationState = OperationStatus::State::Done;
        int done = 0;
        Message step;
        int axis = 0;
        friend bool operator==(const Shown &, const Shown &) = default;
    };
    Shown m_shown;
    std::map<DeviceId, std::uint64_t> m_revisions;
    std::map<DeviceId, ParameterReference> m_asFound;
    std::set<DeviceId> m_asked;
    DeviceId m_importedInto;
    std::unique_ptr<StagedEdits> m_fileEdits;
    QString m_fileName;
    std::optional<ParameterReference> m_fileReference;
    ParameterModel *m_model = nullptr;
    QStackedWidget *m_stack = nullptr;
    EmptyState *m_empty = nullptr;
    CommandButton *m_openFile = nullptr;
    ReadStatus *m_status = nullptr;
    IconButton *m_undo = nullptr;
    IconButton *m_redo = nullptr;
    CommandButton *m_read = nullptr;
    CommandButton *m_import = nullptr;
    CommandButton *m_export = nullptr;
    CommandButton *m_snapshot = nullptr;
    CommandButton *m_showHistory = nullptr;
    HistoryPanel *m_history = nullptr;
    QWidget *m_tools = nullptr;
    SearchField *m_search = nullptr;
    Segmented *m_segments = nullptr;
    Segmented *m_axes = nullptr;     ///< of boards with several axes
    CommandButton *m_copy = nullptr; ///< from another axis
    bool m_boardOnly = false;        ///< the rows that no axis has
    int m_comparedAxis = 0;
    QComboBox *m_compare = nullptr;
    QSplitter *m_splitter = nullptr;
    ParameterView *m_view = nullptr;
    ParameterFoot *m_foot = nullptr;
    ChangesPanel *m_panel = nullptr;
};

} // namespace mb
