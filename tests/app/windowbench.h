// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/application.h"
#include "askengine.h"
#include "model/registry.h"
#include "widgets/common/headerbar.h"
#include "widgets/firmware/firmwarepage.h"

#include <QTest>

#include <algorithm>

namespace mb::test {

/// Of one wait for something that takes milliseconds on an idle machine.
constexpr int patience = 30000;

/// The program as `motorbench --demo` runs it: engine thread, window, stop keys, simulated controllers.
class WindowBench {
public:
    static constexpr int tuned = 5;
    static constexpr int inBootloader = 9;
    static constexpr std::size_t benchSize = 6; ///< three DMC60C, and an Abstract DC Drive of each dialect

    explicit WindowBench(double fontScale = 1.0, const QString &language = QStringLiteral("en"))
        : m_application(*qApp, options(fontScale, language))
    {
        m_application.start();
        QApplication::setActiveWindow(&window());
    }
    [[nodiscard]] MainWindow &window() { return m_application.window(); }
    [[nodiscard]] Arming &arming() { return window().arming(); }
    [[nodiscard]] Engine &engine() { return m_application.engine(); }
    template <class T> [[nodiscard]] T &part() { return *window().findChild<T *>(); }
    template <class T> [[nodiscard]] T &page(PageId id)
    {
        window().showPage(id);
        return *qobject_cast<T *>(window().page(id));
    }

    [[nodiscard]] const DeviceView *device(int address, std::string_view family = "dmc60c")
    {
        const auto &all = engine().snapshot().devices;
        const auto found = std::find_if(all.begin(), all.end(),
            [=](const DeviceView &d) { return d.identity->address == address && d.family->key == family; });
        return found == all.end() ? nullptr : &*found;
    }
    /// All have answered and told who they are, as far as they can, and the one that is tuned may be armed.
    [[nodiscard]] bool isFound()
    {
        std::vector<DeviceView> all = engine().snapshot().devices;
        std::erase_if(all, [](const DeviceView &d) { return d.link != "sim:can"; });
        const DeviceView *unit = device(tuned);
        return all.size() == benchSize && unit && unit->liveness.heard && unit->mayNotMove.empty()
            && std::all_of(all.begin(), all.end(),
                [](const DeviceView &d) { return !d.identity->serial.empty() || !d.identity->dialect.empty(); });
    }
    void select(int address) { window().selection().select(device(address)->id); }
    [[nodiscard]] const ParameterStore::Entry &parameter(int address, std::string_view key)
    {
        const DeviceView *view = device(address);
        return (*view->parameters)[findParameter(view->family->parameters, key).value().value];
    }
    [[nodiscard]] bool isRead(int address)
    {
        const auto &all = device(address)->parameters;
        return std::all_of(all->begin(), all->end(), [](const ParameterStore::Entry &e) { return e.raw.has_value(); });
    }

    /// The truth, not what the device says: whether the bridge of the simulated controller drives its motor.
    [[nodiscard]] bool isOutputOn()
    {
        return test::askEngine<bool>(engine(), [](EngineCore &core) {
            for (const Link *link : core.session().links()) {
                for (const Simulator *unit : core.session().bench(*link)->simulators()) {
                    if (unit->isOutputOn())
                        return true;
                }
            }
            return false;
        });
    }
    /// The unit in its bootloader gets its firmware, once it is found.
    void beginUpdate()
    {
        QTRY_VERIFY_WITH_TIMEOUT(isFound(), patience);
        select(inBootloader);
        auto &firmware = page<FirmwarePage>(PageId::Firmware);
        firmware.loadImage(QStringLiteral(":/firmware/dmc60c-demo.hex"));
        QTRY_VERIFY_WITH_TIMEOUT(firmware.canStart(), patience);
        firmware.startUpdate();
    }
    void run(double duty = 0.3)
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = duty;
        arming().run(setPoint);
    }

private:
    static Options options(double fontScale, const QString &language)
    {
        Options options;
        options.demo = true;
        options.size = QStringLiteral("1280x800");
        options.language = language;
        options.fontScale = fontScale;
        return options;
    }

    Application m_application;
};

} // namespace mb::test
