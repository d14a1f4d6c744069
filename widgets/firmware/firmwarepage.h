// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QTableWidget;
class QVBoxLayout;

namespace mb {

class Banner;
class CommandButton;
class PageMap;
class RoutePanel;
class StepsPanel;
class StateGlyph;

/// Firmware of the selected device: image, checks before the start, page map, rate, time left, cancel, log. Says done only
/// when the device has answered with the new version.
class FirmwarePage : public QWidget {
    Q_OBJECT
public:
    FirmwarePage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent = nullptr);

    /// Reads and checks an image; what is wrong with it stands in the page.
    void loadImage(const QString &path);
    /// As the button: does nothing unless everything before the start holds.
    void startUpdate();
    [[nodiscard]] bool canStart() const;

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    struct Check {
        StateGlyph *glyph = nullptr;
        QLabel *text = nullptr;
    };

    void buildImage(QVBoxLayout &column);
    void buildChecks(QVBoxLayout &column);
    void buildProgress(QVBoxLayout &column);
    void buildBody(QVBoxLayout &column);
    [[nodiscard]] QWidget *buildLog(QWidget *parent);
    [[nodiscard]] QWidget *buildSide(QWidget *parent);
    void askImage();
    void askSaveLog();
    void inspectImage();
    void follow();
    void followChecks(const DeviceView *device, const OperationView *operation);
    void followProgress(const OperationView *operation);
    void followLog(const OperationView *operation);
    void followSafety(const OperationView *operation);
    void setCheck(const Check &check, bool holds, const QString &text);
    void followRoute(const DeviceView *device, const OperationView *operation);
    [[nodiscard]] static const UpdateRoute *routeOf(const DeviceView *device);
    [[nodiscard]] QString imageText() const;
    [[nodiscard]] const OperationView *updateOf(const DeviceView *device) const;
    [[nodiscard]] const OperationView *shownOperation(const DeviceView *device) const;
    [[nodiscard]] QString hindrance() const;
    [[nodiscard]] QString timeOf(Instant time) const;
    [[nodiscard]] QString remaining(const OperationStatus &status) const;
    [[nodiscard]] UpdateWords wordsFor(const OperationView *operation) const;
    [[nodiscard]] static QString result(const UpdateReport &report, const UpdateWords &words);

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    QString m_path;
    std::shared_ptr<const FirmwareImage> m_image;
    std::optional<ImageSummary> m_summary;
    QString m_imageError;
    DeviceId m_inspectedFor;
    QLabel *m_imageName = nullptr;
    QLabel *m_imageDetail = nullptr;
    QLabel *m_deviceName = nullptr;
    QLabel *m_versions = nullptr;
    std::array<Check, 4> m_checks{};
    RoutePanel *m_route = nullptr;
    CommandButton *m_start = nullptr;
    CommandButton *m_cancel = nullptr;
    QLabel *m_step = nullptr;
    QLabel *m_rate = nullptr;
    QProgressBar *m_progress = nullptr;
    QTableWidget *m_log = nullptr;
    QWidget *m_safety = nullptr;
    QLabel *m_safetyTitle = nullptr;
    QLabel *m_safetyText = nullptr;
    QWidget *m_pagesOfFlash = nullptr;
    PageMap *m_map = nullptr;
    StepsPanel *m_steps = nullptr;
    QLabel *m_notes = nullptr;
    OperationId m_shownOperation;
    std::size_t m_shownLines = 0;
};

} // namespace mb
