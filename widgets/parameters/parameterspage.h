// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/parameters/fileexchange.h"

#include <QWidget>

class QStackedWidget;
class QVBoxLayout;

namespace mb {

class CommandButton;
class EditDesk;
class EmptyState;
class HistoryPanel;
class ParameterCommands;
class ParameterHead;
class ParameterSheet;
class ParameterTools;

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
    [[nodiscard]] ParameterView &view();
    [[nodiscard]] HistoryPanel &history() { return *m_history; }

    void readAll();
    /// Sends what is staged, ticked and legal, in the order of the panel.
    void write();
    /// What the selected device has in RAM only, also while another page is shown.
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
    /// Also while another page is shown.
    void takeSnapshot();
    /// The last edit; where none is staged, the last write to the unit, by a new one.
    void undo(bool redo);

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *) override { fit(); }

private:
    void fit();
    void ask(const QString &title, void (ParametersPage::*then)(const QString &path));
    void buildEmpty();
    QWidget *buildTable(BannerStack &banners);
    void connectHead();
    void connectSheet();
    void buildKeys();
    void follow();
    void choose();
    void showDevice(const DeviceView &device);
    void showEmpty();
    void refresh();
    void refreshTexts();
    void setFilter();
    [[nodiscard]] const DeviceView *device() const { return m_workbench.snapshot().device(m_selection.device()); }

    Workbench &m_workbench;
    EditDesk &m_desk;
    Selection &m_selection;
    const ThemeSource &m_theme;
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
        std::optional<int> axis;
        friend bool operator==(const Shown &, const Shown &) = default;
    };
    Shown m_shown;
    std::optional<OpenedFile> m_file; ///< that is shown instead of a device
    ParameterModel *m_model = nullptr;
    ParameterCommands *m_commands = nullptr;
    FileExchange *m_exchange = nullptr;
    QStackedWidget *m_stack = nullptr;
    EmptyState *m_empty = nullptr;
    CommandButton *m_openFile = nullptr;
    QVBoxLayout *m_column = nullptr;
    ParameterHead *m_head = nullptr;
    ParameterTools *m_tools = nullptr;
    ParameterSheet *m_sheet = nullptr;
    HistoryPanel *m_history = nullptr;
};

} // namespace mb
