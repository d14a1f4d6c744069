// SPDX-License-Identifier: GPL-3.0-or-later
// The window's own engine, window and arming, without a screen, driving device 5 of a link until it is killed:
//     windowdriver LINK      prints "driving" once a snapshot shows the motor moving
// For tests/socketcan/kill-window. The lease is renewed where the program renews it, on the GUI thread.
#include "app/engine.h"
#include "app/mainwindow.h"
#include "model/registry.h"

#include <QApplication>

#include <cstdio>

namespace {

/// What the program should do next, from each snapshot.
class Driver {
public:
    Driver(mb::Engine &engine, mb::MainWindow &window)
        : m_engine(engine)
        , m_window(window)
    {
    }
    void follow()
    {
        for (const mb::DeviceView &device : m_engine.snapshot().devices) {
            if (device.identity.address == 5)
                follow(device);
        }
    }

private:
    void follow(const mb::DeviceView &device)
    {
        mb::Arming &arming = m_window.arming();
        if (arming.state() == mb::LampState::Safe && device.liveness.heard && device.mayNotMove.empty()) {
            arming.arm(device.id);
            mb::SetPoint setPoint;
            setPoint.mode = mb::Mode::Duty;
            setPoint.target = 0.3;
            arming.run(setPoint);
        } else if (!m_told && device.motion.running && device.liveness.moving) {
            m_told = true;
            std::puts("driving");
            std::fflush(stdout);
        } else if (arming.state() == mb::LampState::Stopped) {
            std::fprintf(stderr, "windowdriver: stopped: %s\n", qPrintable(arming.reason()));
            QCoreApplication::exit(1);
        }
    }

    mb::Engine &m_engine;
    mb::MainWindow &m_window;
    bool m_told = false;
};

} // namespace

int main(int argc, char **argv)
{
    const auto link = argc == 2 ? mb::LinkAddress::parse(argv[1]) : mb::fail(mb::Fault::OutOfRange, "");
    if (!link) {
        std::fputs("usage: windowdriver LINK\n", stderr);
        return 2;
    }
    QApplication::setStyle(QStringLiteral("Fusion"));
    const QApplication application(argc, argv);
    mb::ThemeSource theme(mb::darkTheme());
    mb::Settings settings(false);
    mb::Engine engine(mb::families(), false);
    mb::MainWindow window(engine, theme, settings);
    Driver driver(engine, window);
    QObject::connect(&engine, &mb::Workbench::changed, &window, [&driver] { driver.follow(); });
    engine.openLink(*link, [](const mb::Result<void> &opened) {
        if (opened)
            return;
        std::fprintf(stderr, "windowdriver: %s\n", opened.error().detail.c_str());
        QCoreApplication::exit(5);
    });
    window.show();
    return QApplication::exec();
}
