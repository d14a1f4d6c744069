// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/derivedsignal.h"
#include "widgets/common/workbench.h"
#include "widgets/plots/signallist.h"

#include <QCoreApplication>

#include <deque>

namespace mb {

/// A signal by names that outlast devices and links.
struct SignalAddress {
    std::string device; ///< selector; empty: a derived signal
    std::string key;    ///< of the channel, or the name of the derived signal
    friend bool operator==(const SignalAddress &, const SignalAddress &) = default;
};

/// Every signal that can be plotted: the channels of the devices that are there, and what formulas make of them. GUI thread.
class SignalBook {
    Q_DECLARE_TR_FUNCTIONS(mb::SignalBook)
public:
    /// What a name in a formula means: settled once, whatever other devices come.
    struct Meaning {
        QString name;
        SignalAddress address;
    };
    struct Derived {
        QString name;
        QString unit;
        QString formula;
        std::vector<Meaning> meanings{}; ///< nothing until every device of its formula was there
        std::vector<Signal> inputs{};    ///< as many, with their rows: another row is another unit
        std::vector<const Channel *> rows{};
        std::shared_ptr<DerivedSignal> signal{}; ///< nothing until then
    };
    /// A signal as formulas call it: d5_velocity; where several devices have the number, dmc60c5_velocity, and where that is not enough
    /// dmc60c5_can1_velocity.
    struct Variable {
        QString name;
        Signal signal;
    };

    explicit SignalBook(Workbench &workbench);

    /// nullptr where the signal is not there (any more).
    [[nodiscard]] const Channel *rowOf(const Signal &signal) const;
    [[nodiscard]] std::shared_ptr<const Telemetry> telemetryOf(const Signal &signal) const;
    /// Of one that is there.
    [[nodiscard]] QString nameOf(const Signal &signal) const;
    [[nodiscard]] std::vector<Variable> variables() const;
    /// As layouts name it: the selector of its device, empty for a derived one, and the key of the channel, or the name. Of one that is there.
    [[nodiscard]] SignalAddress addressOf(const Signal &signal) const;
    /// Nothing where it is not there.
    [[nodiscard]] std::optional<Signal> find(const SignalAddress &address) const;

    /// By their place, which stays while others go; one without a name is gone.
    [[nodiscard]] const std::deque<Derived> &derived() const { return m_derived; }
    /// nullptr for the channel of a device.
    [[nodiscard]] const Derived *derivedOf(const Signal &signal) const;
    /// Whose samples it is made of: of a derived one those of its inputs, as far as they are there.
    [[nodiscard]] std::vector<const DeviceView *> devicesOf(const Signal &signal) const;
    /// Address of the link of the first of them; empty: none is there.
    [[nodiscard]] std::string linkOf(const Signal &signal) const;
    /// Nothing, or what is wrong with the name or the formula.
    [[nodiscard]] QString whatIsWrong(const QString &name, const QString &formula) const;
    /// Yields what is wrong with the formula, or the new signal.
    [[nodiscard]] Result<Signal> add(const QString &name, const QString &unit, const QString &formula);
    /// As add(), unless there is one of this name.
    void ensure(const QString &name, const QString &unit, const QString &formula, std::vector<Meaning> meanings = {});
    void remove(const Signal &signal);
    /// Devices have come, or have begun anew: whether a formula is computed from others now.
    [[nodiscard]] bool complete();
    /// Goes on computing, for a few milliseconds at most.
    void advance();

private:
    /// A name that more than one device could have; empty: there is none.
    [[nodiscard]] QString whatIsAmbiguous(const QString &formula) const;
    bool compile(Derived &derived) const;
    [[nodiscard]] std::vector<Meaning> meaningsOf(const Derived &derived) const;
    [[nodiscard]] bool isOfNow(Derived &derived) const;

    Workbench &m_workbench;
    std::deque<Derived> m_derived;
};

} // namespace mb
