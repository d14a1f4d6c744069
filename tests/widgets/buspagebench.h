// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "busbench.h"
#include "support/timers.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/segmented.h"
#include "widgets/monitor/busbar.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/sendpanel.h"
#include "widgets/monitor/trafficview.h"

#include <QCheckBox>
#include <QClipboard>
#include <QScrollBar>
#include <QSpinBox>

namespace mb::test {

/// The page over a fake workbench with DMC60C 5 and 7 on one simulated link.
struct BusBench {
    FakeTraffic traffic;
    Duration past{}; ///< since the last frame
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    Arming arming{workbench};
    std::unique_ptr<BusPage> page;

    BusBench()
    {
        applyTheme(*qApp, theme.theme());
        workbench.shot.links = {canLink(traffic.log)};
        workbench.shot.devices = {readDrive(1, 5), readDrive(2, 7)};
        for (DeviceView &device : workbench.shot.devices)
            device.link = "sim:can";
        page = std::make_unique<BusPage>(workbench, arming, theme);
        page->resize(1280, 760);
        page->show();
        publish();
    }
    void publish()
    {
        past += 250ms;
        workbench.time = traffic.now + past;
        workbench.publish();
        page->tick();
    }
    template <class T> [[nodiscard]] T *named(const char *name) const
    {
        for (T *child : page->findChildren<T *>()) {
            if (child->accessibleName() == QLatin1String(name))
                return child;
        }
        return nullptr;
    }
    [[nodiscard]] SendPanel &panel() const { return *page->findChild<SendPanel *>(); }
    [[nodiscard]] HoldButton &sendButton() const { return *page->findChild<HoldButton *>(); }
    void type(const char *id, const char *data)
    {
        panel().show();
        named<Segmented>("Length of the identifier")->setCurrent(qstrlen(id) > 3 ? 1 : 0);
        named<QLineEdit>("Identifier")->setText(QLatin1String(id));
        named<QLineEdit>("Data")->setText(QLatin1String(data));
    }
    /// Presses for so long.
    void hold(int milliseconds)
    {
        QTest::mousePress(&sendButton(), Qt::LeftButton);
        passTimers(std::chrono::milliseconds(milliseconds));
        QTest::mouseRelease(&sendButton(), Qt::LeftButton);
    }
    /// Presses until it is so; false when that does not come.
    template <class Condition> [[nodiscard]] bool holdUntil(Condition reached)
    {
        QTest::mousePress(&sendButton(), Qt::LeftButton);
        const bool came = QTest::qWaitFor(reached);
        QTest::mouseRelease(&sendButton(), Qt::LeftButton);
        return came;
    }
    [[nodiscard]] QString panelText() const
    {
        QString text;
        for (const QLabel *label : panel().findChildren<QLabel *>())
            text += label->text() + QLatin1Char('\n');
        return text;
    }
    [[nodiscard]] std::size_t sent() const { return workbench.given<orders::SendFrame>().size(); }
};

} // namespace mb::test
