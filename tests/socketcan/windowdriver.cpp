// SPDX-License-Identifier: GPL-3.0-or-later
// The window's own engine, window and arming, without a screen, driving device 5 of a link, or all axes of a board, until it is killed:
//     windowdriver LINK          prints "driving" once a snapshot shows the motor moving, on a board every motor; ends by SIGTERM as the
//                                window does
//     windowdriver LINK FAMILY   drives device 5 of this family, where there are several
//     windowdriver LINK listen   only watches; prints "listening", and at the end of its input "RX LOST"
//     windowdriver LINK record FILE   records; prints "recording", and at the end of its input, once the file is closed,
//                                     "FRAMES LOST"
//     windowdriver LINK serve RECIPE UNITS   production with this recipe until so many units have ended; a line of JSON for each
// For tests/console/fifty_units.py, tests/safety, and tests/socketcan/kill-window, full-load and recording. The lease is renewed where the program renews it, on the GUI thread.
#include "app/closing.h"
#include "app/endsignals.h"
#include "app/engine.h"
#include "app/mainwindow.h"
#include "app/productionface.h"
#include "model/registry.h"
#include "widgets/common/holdbutton.h"
#include "widgets/service/productionpage.h"

#include <QApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSocketNotifier>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace {

/// What the program should do next, from each snapshot.
class Driver {
public:
    Driver(mb::Engine &engine, mb::MainWindow &window, std::string_view family)
        : m_engine(engine)
        , m_window(window)
        , m_family(family)
    {
    }
    void follow()
    {
        if (m_window.closing().isEnding())
            return;
        for (const mb::DeviceView &device : m_engine.snapshot().devices) {
            const bool board = device.family->capabilities.axes > 1;
            if ((board || device.identity->address == 5) && (m_family.empty() || device.family->key == m_family))
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
            const auto modes = device.family->modes;
            const bool hasDuty = std::find(modes.begin(), modes.end(), mb::Mode::Duty) != modes.end();
            setPoint.mode = hasDuty ? mb::Mode::Duty : mb::Mode::Velocity;
            setPoint.target = hasDuty ? 0.3 : 200.0;
            for (setPoint.axis = 1; setPoint.axis <= device.family->capabilities.axes; ++setPoint.axis)
                arming.run(setPoint);
        } else if (!m_told && device.motion.running && device.liveness.moving && turnsOnEveryAxis(device)) {
            m_told = true;
            std::puts("driving");
            std::fflush(stdout);
        } else if (arming.state() == mb::LampState::Stopped) {
            std::fprintf(stderr, "windowdriver: stopped: %s\n", qPrintable(arming.reason()));
            QCoreApplication::exit(1);
        }
    }

    /// What a device with one motor shows is `liveness.moving`.
    [[nodiscard]] static bool turnsOnEveryAxis(const mb::DeviceView &device)
    {
        const auto channels = device.telemetry->channels();
        for (std::uint16_t i = 0; i < channels.size(); ++i) {
            const std::string_view key = channels[i].key;
            if (!key.starts_with("ch") || !key.ends_with(".velocity"))
                continue;
            const auto now = device.telemetry->latest({i});
            if (!now || now->value == 0.0)
                return false;
        }
        return true;
    }

    mb::Engine &m_engine;
    mb::MainWindow &m_window;
    std::string_view m_family;
    bool m_told = false;
};

/// Counts what comes, until standard input ends and no more comes.
class Listener {
public:
    explicit Listener(mb::Engine &engine)
        : m_engine(engine)
        , m_input(0, QSocketNotifier::Read)
    {
        QObject::connect(&m_input, &QSocketNotifier::activated, &m_input, [this] {
            m_input.setEnabled(false);
            m_ending = true;
        });
    }
    void follow()
    {
        if (m_engine.snapshot().links.empty())
            return;
        const mb::LinkView &link = m_engine.snapshot().links.front();
        if (!m_told) {
            m_told = true;
            std::puts("listening");
            std::fflush(stdout);
        }
        m_quiet = link.counters.rx == m_received ? m_quiet + 1 : 0;
        m_received = link.counters.rx;
        constexpr int snapshotsOfSilence = 40; // more than a second
        if (!m_ending || m_quiet < snapshotsOfSilence)
            return;
        std::printf("%llu %llu\n", static_cast<unsigned long long>(m_received),
            static_cast<unsigned long long>(link.counters.lost));
        QCoreApplication::exit(0);
    }

private:
    mb::Engine &m_engine;
    QSocketNotifier m_input;
    std::uint64_t m_received = 0;
    int m_quiet = 0;
    bool m_ending = false;
    bool m_told = false;
};

/// Records until standard input ends, and then what was still on its way.
class RecordingUser {
public:
    RecordingUser(mb::Engine &engine, std::string link, const char *file)
        : m_engine(engine)
        , m_link(std::move(link))
        , m_file(QString::fromLocal8Bit(file))
        , m_input(0, QSocketNotifier::Read)
    {
        m_input.setEnabled(false);
        QObject::connect(&m_input, &QSocketNotifier::activated, &m_input, [this] {
            m_input.setEnabled(false);
            m_snapshotsLeft = 10; // a third of a second
        });
    }
    void follow()
    {
        const mb::LinkView *link = m_engine.snapshot().link(m_link);
        if (!link)
            return;
        if (!m_begun) {
            m_begun = true;
            m_engine.send(mb::orders::StartRecording{m_link, QFile::encodeName(m_file).toStdString()},
                [this](const mb::Result<void> &begun) { tell(begun); });
        } else if (m_snapshotsLeft > 0 && --m_snapshotsLeft == 0) {
            m_engine.send(mb::orders::StopRecording{m_link});
        } else if (link->recording && link->recording->finished) {
            const mb::RecordingState &end = *link->recording;
            std::fprintf(stderr, "%s", end.problem.english().c_str());
            std::printf(
                "%llu %llu\n", static_cast<unsigned long long>(end.frames), static_cast<unsigned long long>(end.lost));
            QCoreApplication::exit(end.problem.empty() ? 0 : 1);
        }
    }

private:
    void tell(const mb::Result<void> &begun)
    {
        if (!begun) {
            std::fprintf(stderr, "windowdriver: %s\n", begun.error().text().c_str());
            return QCoreApplication::exit(5);
        }
        std::puts("recording");
        std::fflush(stdout);
        m_input.setEnabled(true);
    }

    mb::Engine &m_engine;
    std::string m_link;
    QString m_file;
    QSocketNotifier m_input;
    int m_snapshotsLeft = 0;
    bool m_begun = false;
};

/// Production as its user has it: opens the recipe and starts; holds Arm once, and again after a FAIL, which ends that. Nothing else
/// is touched, whatever units come.
class Producer {
public:
    Producer(mb::Engine &engine, mb::MainWindow &window, const char *recipe, int units)
        : m_engine(engine)
        , m_recipe(QString::fromLocal8Bit(recipe))
        , m_units(units)
    {
        window.production().show(true);
        m_page = window.findChild<mb::ProductionPage *>();
        QObject::connect(
            &m_engine, &mb::Workbench::unitEnded, m_page, [this](const mb::service::Visit &visit) { tell(visit); });
        QObject::connect(&m_engine, &mb::Workbench::serviceChanged, m_page, [this] { arm(); });
    }
    void follow()
    {
        const auto &links = m_engine.snapshot().links;
        const bool open = !links.empty() && links.front().state == mb::LinkState::Open;
        if (!open || std::exchange(m_begun, true))
            return;
        if (!m_page->openRecipe(m_recipe))
            return QCoreApplication::exit(2);
        m_page->start();
    }

private:
    void arm()
    {
        const mb::ServiceView &view = m_engine.service();
        m_holds = m_holds && !view.isArmed();
        if (!view.running || view.isArmed() || m_page->armButton().isHidden() || std::exchange(m_holds, true))
            return;
        ++m_touched;
        Q_EMIT m_page->armButton().activated();
    }
    void tell(const mb::service::Visit &visit)
    {
        const QJsonObject line{{QStringLiteral("serial"), QString::fromStdString(visit.serial)},
            {QStringLiteral("result"), QString::fromStdString(std::string(toString(visit.outcome)))}};
        std::puts(QJsonDocument(line).toJson(QJsonDocument::Compact).constData());
        std::fflush(stdout);
        if (++m_ended < m_units)
            return;
        std::printf("armed %d times, nothing else touched\n", m_touched);
        QCoreApplication::exit(0);
    }

    mb::Engine &m_engine;
    mb::ProductionPage *m_page = nullptr;
    QString m_recipe;
    int m_units;
    int m_ended = 0;
    int m_touched = 0;
    bool m_begun = false;
    bool m_holds = false;
};

} // namespace

int main(int argc, char **argv)
{
    const bool serves = argc == 5 && std::string_view(argv[2]) == "serve";
    const bool listens = argc == 3 && std::string_view(argv[2]) == "listen";
    const bool records = argc == 4 && std::string_view(argv[2]) == "record";
    const auto link = argc == 2 || argc == 3 || records || serves ? mb::LinkAddress::parse(argv[1])
                                                                  : mb::fail(mb::Fault::OutOfRange);
    if (!link) {
        std::fputs("usage: windowdriver LINK [listen | FAMILY | record FILE | serve RECIPE UNITS]\n", stderr);
        return 2;
    }
    QApplication::setStyle(QStringLiteral("Fusion"));
    const QApplication application(argc, argv);
    mb::ThemeSource theme(mb::darkTheme());
    mb::Settings settings(false);
    mb::Engine engine(mb::families(), false);
    mb::MainWindow window(engine, theme, settings);
    const mb::EndSignals endSignals([&window] { window.closing().end(); });
    Driver driver(engine, window, argc == 3 ? argv[2] : "");
    std::optional<Listener> listener;
    if (listens)
        listener.emplace(engine);
    std::optional<RecordingUser> recorder;
    if (records)
        recorder.emplace(engine, link->text(), argv[3]);
    std::optional<Producer> producer;
    if (serves)
        producer.emplace(engine, window, argv[3], std::atoi(argv[4]));
    QObject::connect(&engine, &mb::Workbench::changed, &window, [&driver, &listener, &recorder, &producer] {
        if (producer)
            producer->follow();
        else if (recorder)
            recorder->follow();
        else if (listener)
            listener->follow();
        else
            driver.follow();
    });
    engine.send(mb::orders::OpenLink{*link}, [](const mb::Result<void> &opened) {
        if (opened)
            return;
        std::fprintf(stderr, "windowdriver: %s\n", opened.error().text().c_str());
        QCoreApplication::exit(5);
    });
    QTimer again; // as its user would, where a busy machine made a scan find nobody
    QObject::connect(&again, &QTimer::timeout, &engine, [&engine] {
        if (engine.snapshot().devices.empty())
            engine.send(mb::orders::ScanLinks{});
    });
    if (!serves) // whoever serves units looks for them
        again.start(std::chrono::seconds(3));
    window.show();
    const int status = QApplication::exec();
    return window.closing().unstopped().isEmpty() ? status : 4;
}
