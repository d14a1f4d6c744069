// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicephrases.h"

#include "widgets/common/devicetext.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace mb {
namespace {

// One without placeholders is found wherever it stands; of the others the first that fits is taken.
// clang-format off
constexpr auto phrases = std::to_array<const char *>({
    // links
    QT_TRANSLATE_NOOP("table", "found on %1"),
    QT_TRANSLATE_NOOP("table", "does not answer any more"),
    QT_TRANSLATE_NOOP("table", "answers again"),
    QT_TRANSLATE_NOOP("table", "is gone"),
    QT_TRANSLATE_NOOP("table", "the window did not respond in time"),
    QT_TRANSLATE_NOOP("table", "one update a bus: %1 is being written; nothing was sent"),
    QT_TRANSLATE_NOOP("table", "%1 is switched off; bring it up: %2"),
    QT_TRANSLATE_NOOP("table", "%1 is bus-off; check wiring, termination and bit rate, then: %2"),
    QT_TRANSLATE_NOOP("table", "no permission to open CAN sockets here; allow them in the container or sandbox"),
    QT_TRANSLATE_NOOP("table", "this kernel has no CAN support; load it: %1"),
    QT_TRANSLATE_NOOP("table", "CAN sockets cannot be opened: %1"),
    QT_TRANSLATE_NOOP("table", "the kernel does not list its interfaces: %1"),
    QT_TRANSLATE_NOOP("table", "there is no CAN interface; plug in an adapter"),
    QT_TRANSLATE_NOOP("table", "there is no CAN interface %1"),
    QT_TRANSLATE_NOOP("table", "%1 is a network interface, but not one for CAN"),
    QT_TRANSLATE_NOOP("table", "%1 was switched off"),
    QT_TRANSLATE_NOOP("table", "%1 is gone"),
    QT_TRANSLATE_NOOP("table", "the other end of %1 closed it"),
    QT_TRANSLATE_NOOP("table", "no permission to use %1; allow CAN sockets in the container or sandbox"),
    QT_TRANSLATE_NOOP("table", "no permission to use %1; become a member of its group: %2"),
    QT_TRANSLATE_NOOP("table", "there is no CAN plugin %1; installed are: %2"),
    QT_TRANSLATE_NOOP("table", "%1 was disconnected"),
    QT_TRANSLATE_NOOP("table", "bus-off: the adapter left the bus after too many errors; check wiring, termination and bit rate"),
    QT_TRANSLATE_NOOP("table", "bus-off: the controller left the bus after too many errors; check wiring, termination and bit rate"),
    QT_TRANSLATE_NOOP("table", "bus-off: %1 left the bus after too many errors; check wiring, termination and bit rate"),
    QT_TRANSLATE_NOOP("table", "%1, listen-only: nothing can be sent"),
    QT_TRANSLATE_NOOP("table", "virtual"),
    QT_TRANSLATE_NOOP("table", "%1 links are not supported yet"),
    QT_TRANSLATE_NOOP("table", "socketcan links have no option '%1'"),
    QT_TRANSLATE_NOOP("table", "unknown link kind '%1': sim, socketcan, qtcan, serial, spidev, unix and replay are known"),
    QT_TRANSLATE_NOOP("table", "'%1' is not a link: SCHEME:PATH is needed, such as socketcan:can0 or sim:"),
    QT_TRANSLATE_NOOP("table", "'%1' names no interface"),
    QT_TRANSLATE_NOOP("table", "link option '%1' is not KEY=VALUE"),
    QT_TRANSLATE_NOOP("table", "link option %1 is out of range"),
    QT_TRANSLATE_NOOP("table", "there is no %1; plug in the adapter, or name another port"),
    QT_TRANSLATE_NOOP("table", "%1 is no serial port; name one such as /dev/ttyUSB0"),
    QT_TRANSLATE_NOOP("table", "%1 is in use by another program; close that one first (%2 names it)"),
    QT_TRANSLATE_NOOP("table", "%1 cannot be opened: %2"),
    QT_TRANSLATE_NOOP("table", "%1 cannot do %2 bit/s: %3"),
    QT_TRANSLATE_NOOP("table", "%1 cannot do %2 bit/s; the nearest it can is %3"),
    QT_TRANSLATE_NOOP("table", "%1 bit/s is no rate of a serial line"),
    QT_TRANSLATE_NOOP("table", "%1 was unplugged; plug it in again"),
    QT_TRANSLATE_NOOP("table", "%1 failed (%2); unplug it and plug it in again"),
    QT_TRANSLATE_NOOP("table", "the other end of %1 hung up; start it again"),
    QT_TRANSLATE_NOOP("table", "the cable was pulled out; plug it in again"),
    QT_TRANSLATE_NOOP("table", "the driver of %1 cannot switch the direction of an RS-485 line, so the adapter has to do it by itself; if nothing answers, use one that does"),
    QT_TRANSLATE_NOOP("table", "unknown option '%1' of a serial link; baud, format, rs485 and echo are known"),
    QT_TRANSLATE_NOOP("table", "sim: stands for several links; name one, such as sim:can"),
    QT_TRANSLATE_NOOP("table", "pty: is where 'simulate' puts its devices; open that terminal as serial:%1"),
    QT_TRANSLATE_NOOP("table", "is there"),
    QT_TRANSLATE_NOOP("table", "%1 is not open"),
    QT_TRANSLATE_NOOP("table", "%1 does not open: its driver has not answered for %2 s; unplug it and plug it in again"),
    QT_TRANSLATE_NOOP("table", "%1 is being opened already"),
    QT_TRANSLATE_NOOP("table", "%1 was closed before it was open"),
    QT_TRANSLATE_NOOP("table", "the link is not open"),
    QT_TRANSLATE_NOOP("table", "is back"),
    // recordings
    QT_TRANSLATE_NOOP("table", "%1 is a recording: what is in it can be watched, not driven; open the link that it was made on"),
    QT_TRANSLATE_NOOP("table", "%1 is a recording: it can be watched, not written to or driven; open the link that it was made on"),
    QT_TRANSLATE_NOOP("table", "%1 is no CAN link; only those are recorded"),
    QT_TRANSLATE_NOOP("table", "%1 is being recorded already"),
    QT_TRANSLATE_NOOP("table", "the recording has ended: %1"),
    QT_TRANSLATE_NOOP("table", "%1 frames recorded, none is missing"),
    QT_TRANSLATE_NOOP("table", "%1 frames recorded, %2 are missing"),
    QT_TRANSLATE_NOOP("table", "the disk has not made %1 within 10 s; name another folder"),
    QT_TRANSLATE_NOOP("table", "the disk has not taken %1 for 30 s"),
    QT_TRANSLATE_NOOP("table", "the disk is full; make room, or choose another place"),
    QT_TRANSLATE_NOOP("table", "no permission to write there; choose another folder"),
    QT_TRANSLATE_NOOP("table", "there is no such folder; choose another one"),
    QT_TRANSLATE_NOOP("table", "%1 has a name that ends in no kind of picture; end it in .png, .svg or .pdf"),
    QT_TRANSLATE_NOOP("table", "it is a folder; name a file"),
    QT_TRANSLATE_NOOP("table", "the file has reached the greatest size there; choose another place"),
    QT_TRANSLATE_NOOP("table", "%1: it cannot be written (system error %2); check the disk"),
    QT_TRANSLATE_NOOP("table", "%1: no such file; check the path"),
    QT_TRANSLATE_NOOP("table", "%1: no permission to read it; change its mode, or copy it"),
    QT_TRANSLATE_NOOP("table", "%1: cannot be read (system error %2); check the disk"),
    QT_TRANSLATE_NOOP("table", "%1 is not a file; name a recording"),
    QT_TRANSLATE_NOOP("table", "%1 has no frame in it; record again"),
    QT_TRANSLATE_NOOP("table", "%1 has no frame of %2; leave out interface="),
    QT_TRANSLATE_NOOP("table", "%1: it is a Vector BLF log; save it as ASC and take that"),
    QT_TRANSLATE_NOOP("table", "%1: line %2 is neither a line of candump -L nor the beginning of a Vector ASC log; such a line reads %3"),
    QT_TRANSLATE_NOOP("table", "%1: line %2 is not a line of candump -L; such a line reads %3"),
    QT_TRANSLATE_NOOP("table", "%1: line %2 is not a line of a Vector ASC log: %3; such a line reads %4"),
    QT_TRANSLATE_NOOP("table", "%1: line %2 is not a line of a Vector ASC log; such a line reads %3"),
    QT_TRANSLATE_NOOP("table", "%1 was changed while it was played; open it again"),
    QT_TRANSLATE_NOOP("table", "speed=%1 is no speed; legal is 0.01 … 1000, or max"),
    QT_TRANSLATE_NOOP("table", "replay links have no option '%1'; they have speed and interface"),
    QT_TRANSLATE_NOOP("table", "several units answer under this number in the recording"),
    // connection doctor: causes, then remedies
    QT_TRANSLATE_NOOP("table", "%1 is switched off"),
    QT_TRANSLATE_NOOP("table", "%1 is bus-off"),
    QT_TRANSLATE_NOOP("table", "%1 only listens, nothing can be sent"),
    QT_TRANSLATE_NOOP("table", "nobody acknowledges what %1 sends"),
    QT_TRANSLATE_NOOP("table", "only disturbed frames arrive on %1, the bus has another bit rate than %2"),
    QT_TRANSLATE_NOOP("table", "only disturbed frames arrive on %1, the bus has another bit rate"),
    QT_TRANSLATE_NOOP("table", "the bus leaves no room for what %1 sends"),
    QT_TRANSLATE_NOOP("table", "%1 is %2 with %3 transmit and %4 receive errors"),
    QT_TRANSLATE_NOOP("table", "%1 is error-passive"),
    QT_TRANSLATE_NOOP("table", "%1 is error-warning"),
    QT_TRANSLATE_NOOP("table", "%1 frames were lost, the kernel keeps only %2 for this program"),
    QT_TRANSLATE_NOOP("table", "no permission to open CAN sockets here"),
    QT_TRANSLATE_NOOP("table", "no permission to use %1"),
    QT_TRANSLATE_NOOP("table", "this kernel has no CAN support"),
    QT_TRANSLATE_NOOP("table", "there is no CAN interface"),
    QT_TRANSLATE_NOOP("table", "bring it up"),
    QT_TRANSLATE_NOOP("table", "bring it up as a full member"),
    QT_TRANSLATE_NOOP("table", "load it"),
    QT_TRANSLATE_NOOP("table", "plug in an adapter"),
    QT_TRANSLATE_NOOP("table", "plug in an adapter at any time; it is opened by itself once it is up"),
    QT_TRANSLATE_NOOP("table", "plug the adapter in again; the link is opened by itself as soon as it is up"),
    QT_TRANSLATE_NOOP("table", "allow them in the container or sandbox"),
    QT_TRANSLATE_NOOP("table", "become a member of its group"),
    QT_TRANSLATE_NOOP("table", "check wiring, termination and bit rate, then"),
    QT_TRANSLATE_NOOP("table", "check wiring, termination and bit rate, then reconnect"),
    QT_TRANSLATE_NOOP("table", "check wiring, termination and bit rate; it starts again by itself"),
    QT_TRANSLATE_NOOP("table", "check the cable, both 120 Ω resistors, and that no number is taken twice"),
    QT_TRANSLATE_NOOP("table", "switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate %1"),
    QT_TRANSLATE_NOOP("table", "find it by listening only"),
    QT_TRANSLATE_NOOP("table", "this interface cannot listen without disturbing the bus, so ask who set it up; usual are 1 Mbit/s, 500, 250 and 125 kbit/s"),
    QT_TRANSLATE_NOOP("table", "find the sender that fills it, on the Bus page or with 'motorbenchctl monitor'"),
    QT_TRANSLATE_NOOP("table", "allow more, then close and open the link"),
    QT_TRANSLATE_NOOP("table", "reconnect"),
    QT_TRANSLATE_NOOP("table", "%1 takes no frames: %2 wait to be sent; check that somebody else is on the bus"),
    // motion
    QT_TRANSLATE_NOOP("table", "several units answer as number %1; control is locked until one has another number"),
    QT_TRANSLATE_NOOP("table", "several units answer as number %1"),
    QT_TRANSLATE_NOOP("table", "this unit has no number yet; assign one before it is driven"),
    QT_TRANSLATE_NOOP("table", "no application runs in this unit; update its firmware first"),
    QT_TRANSLATE_NOOP("table", "another master drives %1; stop it there first"),
    QT_TRANSLATE_NOOP("table", "another master sends control frames to this device"),
    QT_TRANSLATE_NOOP("table", "nobody renewed the motion lease"),
    QT_TRANSLATE_NOOP("table", "the computer slept"),
    QT_TRANSLATE_NOOP("table", "this computer is not kept awake while motors are driven or firmware is written: %1; switch its automatic suspend off meanwhile"),
    QT_TRANSLATE_NOOP("table", "this program was held up for %1 ms, longer than the motor goes without a set-point"),
    QT_TRANSLATE_NOOP("table", "the motor was stopped; arm again"),
    QT_TRANSLATE_NOOP("table", "this device has no watchdog, and nothing here would stop it if the program died"),
    QT_TRANSLATE_NOOP("table", "this device has no watchdog, and on %1 nothing could stop it if the program died; use an interface of the kernel"),
    QT_TRANSLATE_NOOP("table", "it is not known how to stop this device from outside"),
    QT_TRANSLATE_NOOP("table", "the guardian does not stand by yet"),
    QT_TRANSLATE_NOOP("table", "no guardian came within two seconds"),
    QT_TRANSLATE_NOOP("table", "this program was held up for so long that the guardian may have stopped the motor"),
    QT_TRANSLATE_NOOP("table", "the guardian stopped the motor because this program was held up"),
    QT_TRANSLATE_NOOP("table", "the guardian sent the stop because this program was held up, not confirmed"),
    QT_TRANSLATE_NOOP("table", "the guardian tried to stop the motor because this program was held up, without an answer"),
    QT_TRANSLATE_NOOP("table", "the device restarted"),
    QT_TRANSLATE_NOOP("table", "the device is not heard any more"),
    QT_TRANSLATE_NOOP("table", "%1 does not answer"),
    QT_TRANSLATE_NOOP("table", "Dialect %1 was chosen by hand, %2. %3"),
    QT_TRANSLATE_NOOP("table", "the unit answered as %1"),
    QT_TRANSLATE_NOOP("table", "none was proven"),
    QT_TRANSLATE_NOOP("table", "stop the motor before its dialect is changed"),
    QT_TRANSLATE_NOOP("table", "%1 has no '%2' to be set"),
    QT_TRANSLATE_NOOP("table", "the device is gone"),
    QT_TRANSLATE_NOOP("table", "the device is busy with something else"),
    QT_TRANSLATE_NOOP("table", "firmware update"),
    QT_TRANSLATE_NOOP("table", "stopped: %1"),
    QT_TRANSLATE_NOOP("table", "follow needs the number of a device"),
    QT_TRANSLATE_NOOP("table", "a device cannot follow itself"),
    QT_TRANSLATE_NOOP("table", "the ramp must be 0 (immediate) or a positive number of duty per second"),
    // identity
    QT_TRANSLATE_NOOP("table", "This unit has no number yet; assign one from 1 to 62."),
    QT_TRANSLATE_NOOP("table", "This unit has no number and no application; assign a number, then update its firmware."),
    QT_TRANSLATE_NOOP("table", "The bootloader runs; restart the unit or update its firmware."),
    QT_TRANSLATE_NOOP("table", "No application runs; update its firmware."),
    QT_TRANSLATE_NOOP("table", "Number %1 is used by %2 units; give each its own before one is driven."),
    QT_TRANSLATE_NOOP("table", "Product %1 is not known to be a DMC60C."),
    QT_TRANSLATE_NOOP("table", "the unit restarted: what is volatile was lost, its parameters are read again"),
    QT_TRANSLATE_NOOP("table", "number %1 is used by another unit"),
    QT_TRANSLATE_NOOP("table", "a device number is 1 … 63"),
    QT_TRANSLATE_NOOP("table", "a name has 1 to 64 characters"),
    QT_TRANSLATE_NOOP("table", "a name may hold Latin-1 characters only"),
    // operations and parameters
    QT_TRANSLATE_NOOP("table", "Identify"),
    QT_TRANSLATE_NOOP("table", "Rename"),
    QT_TRANSLATE_NOOP("table", "Look at the restarted unit"),
    QT_TRANSLATE_NOOP("table", "Read parameters"),
    QT_TRANSLATE_NOOP("table", "Write parameters"),
    QT_TRANSLATE_NOOP("table", "Store to flash"),
    QT_TRANSLATE_NOOP("table", "Assign number"),
    QT_TRANSLATE_NOOP("table", "Read and clear faults"),
    QT_TRANSLATE_NOOP("table", "Set telemetry rate"),
    QT_TRANSLATE_NOOP("table", "Update firmware"),
    QT_TRANSLATE_NOOP("table", "Reading %1"),
    QT_TRANSLATE_NOOP("table", "Read"),
    QT_TRANSLATE_NOOP("table", "Writing %1"),
    QT_TRANSLATE_NOOP("table", "Written"),
    QT_TRANSLATE_NOOP("table", "%1 parameters gave no answer"),
    QT_TRANSLATE_NOOP("table", "all %1 read"),
    QT_TRANSLATE_NOOP("table", "%1 written, read back and equal"),
    QT_TRANSLATE_NOOP("table", "%1 written; they cannot be read back"),
    QT_TRANSLATE_NOOP("table", "%1 written; %2 of them cannot be read back"),
    QT_TRANSLATE_NOOP("table", "stored, the flash sequence number advanced"),
    QT_TRANSLATE_NOOP("table", "stored, not verifiable"),
    QT_TRANSLATE_NOOP("table", "Waiting until the device has written its flash"),
    QT_TRANSLATE_NOOP("table", "the device did not write its flash within 20 s"),
    QT_TRANSLATE_NOOP("table", "the device restarted before its flash was proved to be written; read it again"),
    QT_TRANSLATE_NOOP("table", "the position is written only while the output is off; stop the motor first"),
    QT_TRANSLATE_NOOP("table", "%1 was %2 and is not known to be cleared"),
    QT_TRANSLATE_NOOP("table", "%1 was written as %2 but reads %3"),
    // boards that keep nothing, and what they do not tell
    QT_TRANSLATE_NOOP("table", "Write settings again"),
    QT_TRANSLATE_NOOP("table", "%1 of %2 settings were written again; then the board was reset once more; do it again"),
    QT_TRANSLATE_NOOP("table", "%1 of %2 settings were written again; %3; what is missing is still unknown, do it again"),
    QT_TRANSLATE_NOOP("table", "%1 settings written again"),
    QT_TRANSLATE_NOOP("table", "stop the motors before settings are written again"),
    QT_TRANSLATE_NOOP("table", "the settings that the reset took are written again"),
    QT_TRANSLATE_NOOP("table", "the board was reset since its settings were written; look at it again"),
    QT_TRANSLATE_NOOP("table", "stop the motor before an experiment begins"),
    QT_TRANSLATE_NOOP("table", "stop the motors first"),
    QT_TRANSLATE_NOOP("table", "looking at the status bit"),
    QT_TRANSLATE_NOOP("table", "polarity bit %1: the input is active"),
    QT_TRANSLATE_NOOP("table", "polarity bit %1: the input is not active"),
    QT_TRANSLATE_NOOP("table", "the status bit is the same with both polarities, so it tells nothing; look at the wiring of the input"),
    QT_TRANSLATE_NOOP("table", "polarity 0 is active high: the board follows the maker's library"),
    QT_TRANSLATE_NOOP("table", "polarity 0 is active low: the board follows the data sheet"),
    QT_TRANSLATE_NOOP("table", "turning the motor with several powers"),
    QT_TRANSLATE_NOOP("table", "looking for velocity P"),
    QT_TRANSLATE_NOOP("table", "looking for velocity I"),
    QT_TRANSLATE_NOOP("table", "looking for position P"),
    QT_TRANSLATE_NOOP("table", "looking for position I"),
    QT_TRANSLATE_NOOP("table", "looking for position D"),
    QT_TRANSLATE_NOOP("table", "putting the settings back"),
    QT_TRANSLATE_NOOP("table", "position D has no effect that could be measured; its scale stays unknown"),
    QT_TRANSLATE_NOOP("table", "power %1: %2 and %3 counts/s"),
    QT_TRANSLATE_NOOP("table", "the axis has a power limit of %1 %, which is kept"),
    QT_TRANSLATE_NOOP("table", "the motor gives %1 counts/s per power unit, friction takes %2 units, it follows within %3 ms"),
    QT_TRANSLATE_NOOP("table", "the motors were told to stop, and are not seen to stand"),
    QT_TRANSLATE_NOOP("table", "the motor was stopped: %1"),
    QT_TRANSLATE_NOOP("table", "the motor ran faster than the power limit allows; it was stopped"),
    QT_TRANSLATE_NOOP("table", "the loop drives the motor the wrong way; exchange the wires of the motor or the phases of the encoder"),
    QT_TRANSLATE_NOOP("table", "the encoder counts against the power; exchange the wires of the motor or the phases of the encoder before any loop is closed"),
    QT_TRANSLATE_NOOP("table", "the motor turns differently in both directions; the shaft must be free, without load on one side"),
    QT_TRANSLATE_NOOP("table", "the motor did not turn at two of the powers; allow it more power, or free its shaft"),
    QT_TRANSLATE_NOOP("table", "the speed does not grow evenly with the power; look whether something brakes or limits the motor"),
    QT_TRANSLATE_NOOP("table", "no gain of the velocity loop turns the motor; the board may want velocity targets times 4096: choose that setting, and try again"),
    QT_TRANSLATE_NOOP("table", "no gain of the position loop turns the motor"),
    QT_TRANSLATE_NOOP("table", "the gain scale is too coarse to be measured with so little power"),
    QT_TRANSLATE_NOOP("table", "the motor turned too short a time below the power limit to be measured"),
    QT_TRANSLATE_NOOP("table", "the gains found at different values do not agree, so that a gain is no simple factor"),
    QT_TRANSLATE_NOOP("table", "the board does not tell its position"),
    QT_TRANSLATE_NOOP("table", "the transcript of the update is in %1"),
    QT_TRANSLATE_NOOP("table", "the transcript of the update is not kept: %1"),
    QT_TRANSLATE_NOOP("table", "the jumper is still in: take it out, then reset the board"),
    QT_TRANSLATE_NOOP("table", "%1: legal is %2"),
    QT_TRANSLATE_NOOP("table", "%1 cannot be read from the device"),
    QT_TRANSLATE_NOOP("table", "%1 is read-only"),
    QT_TRANSLATE_NOOP("table", "%1 is above %2; legal is %3"),
    QT_TRANSLATE_NOOP("table", "%1 is below %2; legal is %3"),
    QT_TRANSLATE_NOOP("table", "this firmware does not know the parameter"),
    QT_TRANSLATE_NOOP("table", "the device refused the value"),
    QT_TRANSLATE_NOOP("table", "no answer"),
    QT_TRANSLATE_NOOP("table", "the device answers '%1'"),
    QT_TRANSLATE_NOOP("table", "%1 to number %2"),
    // files
    QT_TRANSLATE_NOOP("table", "%1 cannot be written: %2"),
    QT_TRANSLATE_NOOP("table", "%1 cannot be read: %2"),
    QT_TRANSLATE_NOOP("table", "%1: no such file"),
    QT_TRANSLATE_NOOP("table", "%1: is a directory"),
    QT_TRANSLATE_NOOP("table", "%1: is longer than %2 bytes"),
    QT_TRANSLATE_NOOP("table", "not a parameter file: %1"),
    QT_TRANSLATE_NOOP("table", "no object at the top"),
    QT_TRANSLATE_NOOP("table", "unknown key %1"),
    QT_TRANSLATE_NOOP("table", "%1 was unknown when the file was written"),
    QT_TRANSLATE_NOOP("table", "%1 belongs to the unit that the file was saved from"),
    QT_TRANSLATE_NOOP("table", "%1: its value says %2, its raw value %3; delete the one of the two that is old"),
    QT_TRANSLATE_NOOP("table", "%1: its value is of the wrong kind; write true or false"),
    QT_TRANSLATE_NOOP("table", "%1: its value is of the wrong kind; write a number"),
    QT_TRANSLATE_NOOP("table", "%1: raw is not a whole number; delete it, the value says the same"),
    QT_TRANSLATE_NOOP("table", "the file is for family '%1', the device is a %2"),
    QT_TRANSLATE_NOOP("table", "the file is empty"),
    QT_TRANSLATE_NOOP("table", "the end-of-file record is missing, the file may be cut off"),
    QT_TRANSLATE_NOOP("table", "the file holds no data"),
    QT_TRANSLATE_NOOP("table", "something follows the end-of-file record"),
    QT_TRANSLATE_NOOP("table", "%1 where a record begins with a colon, is this an Intel HEX file?"),
    QT_TRANSLATE_NOOP("table", "checksum is %1, %2 is needed"),
    QT_TRANSLATE_NOOP("table", "line %1: %2"),
    QT_TRANSLATE_NOOP("table", "no data in page 0 (0x00000-0x00FFF), the file is not a whole application"),
    QT_TRANSLATE_NOOP("table", "no data in page 30 (0x1E000-0x1EFFF), where the version is"),
    QT_TRANSLATE_NOOP("table", "not sent: %1 for %2"),
    QT_TRANSLATE_NOOP("table", "not sent: %1 outside the controller's flash"),
    QT_TRANSLATE_NOOP("table", "%1 bytes"),
    QT_TRANSLATE_NOOP("table", "pages 31-34 (configuration and descriptors)"),
    QT_TRANSLATE_NOOP("table", "pages 35-42 (bootloader and flash configuration)"),
    QT_TRANSLATE_NOOP("table", "the user-ID words"),
    // firmware
    QT_TRANSLATE_NOOP("table", "Preflight"),
    QT_TRANSLATE_NOOP("table", "Enter bootloader"),
    QT_TRANSLATE_NOOP("table", "All pages written"),
    QT_TRANSLATE_NOOP("table", "Restart"),
    QT_TRANSLATE_NOOP("table", "Page %1"),
    QT_TRANSLATE_NOOP("table", "image %1 of %2 pages, unit %3, bootloader %4"),
    QT_TRANSLATE_NOOP("table", "without application"),
    QT_TRANSLATE_NOOP("table", "runs %1"),
    QT_TRANSLATE_NOOP("table", "in bootloader %1, session kept"),
    QT_TRANSLATE_NOOP("table", "the device may have restarted: once more from page %1"),
    QT_TRANSLATE_NOOP("table", "the device restarted %1 times during the update"),
    QT_TRANSLATE_NOOP("table", "%1 is lost: %2; waiting up to %3 for it to come back"),
    QT_TRANSLATE_NOOP("table", "Wait for %1"),
    QT_TRANSLATE_NOOP("table", "%1 is back"),
    QT_TRANSLATE_NOOP("table", "%1 did not come back within %2: %3"),
    QT_TRANSLATE_NOOP("table", "all pages are in the unit"),
    QT_TRANSLATE_NOOP("table", "the unit may have restarted meanwhile: once more from page %1"),
    QT_TRANSLATE_NOOP("table", "CRC refused, nothing was erased; trying variant %1"),
    QT_TRANSLATE_NOOP("table", "page %1 accepted with CRC variant %2"),
    QT_TRANSLATE_NOOP("table", "page 0: its status was lost, but the version is there; it is not written again"),
    QT_TRANSLATE_NOOP("table", "page %1: %2, sent again"),
    QT_TRANSLATE_NOOP("table", "arrived damaged, nothing was erased"),
    QT_TRANSLATE_NOOP("table", "the device could not verify its flash"),
    QT_TRANSLATE_NOOP("table", "the byte count was out of step"),
    QT_TRANSLATE_NOOP("table", "no status within 2 s"),
    QT_TRANSLATE_NOOP("table", "page %1 cannot be written: its flash failed the device's own check %2 times"),
    QT_TRANSLATE_NOOP("table", "the bootloader refuses %1"),
    QT_TRANSLATE_NOOP("table", "page %1 was not accepted in %2 tries"),
    QT_TRANSLATE_NOOP("table", "page %1"),
    QT_TRANSLATE_NOOP("table", "restarted, the application answers"),
    QT_TRANSLATE_NOOP("table", "the answer to the reset was lost; found again by enumeration"),
    QT_TRANSLATE_NOOP("table", "%1; the unit waits in its bootloader, run the update again"),
    QT_TRANSLATE_NOOP("table", "the device already runs %1"),
    QT_TRANSLATE_NOOP("table", "the device answers with version %1 instead of %2"),
    QT_TRANSLATE_NOOP("table", "the device answers with version %1"),
    QT_TRANSLATE_NOOP("table", "the image is for product 602, this unit is product %1; nothing was written"),
    QT_TRANSLATE_NOOP("table", "the unit does not answer an enumeration"),
    QT_TRANSLATE_NOOP("table", "firmware: %1"),
    // Supermodified
    QT_TRANSLATE_NOOP("table", "Looking for Supermodified nodes at %1 bit/s"),
    QT_TRANSLATE_NOOP("table", "Supermodified found: %1"),
    QT_TRANSLATE_NOOP("table", "The adapter has no %1 bit/s"),
    QT_TRANSLATE_NOOP("table", "the search was cancelled; what it found stays"),
    QT_TRANSLATE_NOOP("table", "the stop was not acknowledged, so the position was not reset: a motor that runs would jump"),
    QT_TRANSLATE_NOOP("table", "%1 has no command that zeroes its position"),
    QT_TRANSLATE_NOOP("table", "%1 is no list of devices and is ignored: the next scan takes its full time and writes it anew"),
    QT_TRANSLATE_NOOP("table", "Its error level is 1, so every reading fails. Set error.level to 0."),
    QT_TRANSLATE_NOOP("table", "Its answers fit no known dialect."),
    QT_TRANSLATE_NOOP("table", "It is not driven: %1."),
    QT_TRANSLATE_NOOP("table", "%1 becomes %2, it was %3: the device stores it"),
    QT_TRANSLATE_NOOP("table", "%1 becomes %2: the device stores it"),
    QT_TRANSLATE_NOOP("table", "this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then"),
    QT_TRANSLATE_NOOP("table", "what is sent to node %1 is also done by node %2, now or after a restart, because of an acceptance mask; set its node.mask to 255 and restart it"),
    QT_TRANSLATE_NOOP("table", "every id that this program could use on the line belongs to the group of a node, so answers would be taken for commands; set node.mask to 255 and restart the nodes"),
    QT_TRANSLATE_NOOP("table", "its profile is not known, so a move that passes its target could not be told; read profile.velocity and profile.acceleration"),
    QT_TRANSLATE_NOOP("table", "its P or its position is not known, so whether this step overflows its loop is not either; read gain.p"),
    QT_TRANSLATE_NOOP("table", "the profiled move passed its target by more than its stopping distance, as this firmware may above 2500 counts/s; use a lower profile.velocity"),
    QT_TRANSLATE_NOOP("table", "somebody may have started it again, so the position was not reset"),
    QT_TRANSLATE_NOOP("table", "the position was not reset: %1"),
    QT_TRANSLATE_NOOP("table", "%1, and the device switched its output off"),
    QT_TRANSLATE_NOOP("table", "the motor stalled (%1)"),
    QT_TRANSLATE_NOOP("table", "the position left its range upwards (%1)"),
    QT_TRANSLATE_NOOP("table", "the position left its range downwards (%1)"),
    QT_TRANSLATE_NOOP("table", "a relative move was not answered, and is never sent twice: look where the motor stands"),
    QT_TRANSLATE_NOOP("table", "the device does not answer"),
    QT_TRANSLATE_NOOP("table", "the device says that the motor is not started; it may have lost its supply"),
    QT_TRANSLATE_NOOP("table", "the stop before it is not acknowledged yet"),
    QT_TRANSLATE_NOOP("table", "a buffered move is not acknowledged yet; try again"),
    QT_TRANSLATE_NOOP("table", "its dialect is not known, so no move can be sent; read it again"),
    QT_TRANSLATE_NOOP("table", "refused: %1"),
    QT_TRANSLATE_NOOP("table", "node %1 does not answer"),
    QT_TRANSLATE_NOOP("table", "node id %1 is used by another node of this line"),
    QT_TRANSLATE_NOOP("table", "a step of %1 counts overflows the loop of this firmware; at most %2 with its P: use a profiled mode or several moves"),
    QT_TRANSLATE_NOOP("table", "Connecting through avrdude"),
    QT_TRANSLATE_NOOP("table", "Erasing flash"),
    QT_TRANSLATE_NOOP("table", "Writing flash"),
    QT_TRANSLATE_NOOP("table", "Verifying flash"),
    QT_TRANSLATE_NOOP("table", "Looking for the controller"),
    QT_TRANSLATE_NOOP("table", "no bootloader answers at %1 bit/s"),
    QT_TRANSLATE_NOOP("table", "avrdude is not installed; install it with: %1"),
    QT_TRANSLATE_NOOP("table", "avrdude read back all %1 bytes and they are equal; the controller answers again, dialect %2"),
    QT_TRANSLATE_NOOP("table", "avrdude read back all %1 bytes and they are equal, but the controller does not answer; cut its power for a moment, and scan: a new firmware may have another rate or node id"),
    QT_TRANSLATE_NOOP("table", "a motor is driven on this line; stop it first"),
    QT_TRANSLATE_NOOP("table", "%1; the controller may hold half a program, and runs again once an update has succeeded"),
    // any cause behind what it happened to
    QT_TRANSLATE_NOOP("table", "%1: %2"),
});
// clang-format on

/// Where the next placeholder is; the length of the phrase without one.
std::size_t placeholder(std::string_view phrase)
{
    for (std::size_t i = 0; i + 1 < phrase.size(); ++i) {
        if (phrase[i] == '%' && phrase[i + 1] >= '1' && phrase[i + 1] <= '9')
            return i;
    }
    return phrase.size();
}

/// What stands for the placeholders, which are numbered in their order; nothing if the text does not fit.
std::optional<std::vector<std::string_view>> valuesIn(std::string_view text, std::string_view phrase)
{
    std::vector<std::string_view> values;
    std::size_t mark = placeholder(phrase);
    if (!text.starts_with(phrase.substr(0, mark)))
        return std::nullopt;
    text.remove_prefix(mark);
    while (mark < phrase.size()) {
        phrase.remove_prefix(mark + 2);
        mark = placeholder(phrase);
        const std::string_view words = phrase.substr(0, mark);
        const bool last = mark == phrase.size();
        const std::size_t end = !last ? text.find(words)
            : text.ends_with(words)   ? text.size() - words.size()
                                      : std::string_view::npos;
        if (end == std::string_view::npos || end == 0)
            return std::nullopt;
        values.push_back(text.substr(0, end));
        text.remove_prefix(end + words.size());
    }
    return text.empty() ? std::optional(values) : std::nullopt;
}

QString filled(const QString &phrase, const QStringList &values)
{
    QString text;
    for (int i = 0; i < phrase.size(); ++i) {
        const bool marked = phrase[i] == QLatin1Char('%') && i + 1 < phrase.size();
        const int which = marked ? phrase[i + 1].digitValue() : 0;
        const bool fits = which >= 1 && which <= values.size();
        text += fits ? values[which - 1] : QString(phrase[i]);
        i += fits ? 1 : 0;
    }
    return text;
}

} // namespace

QString devicePhrase(std::string_view english)
{
    const std::string whole(english);
    if (QString text = QCoreApplication::translate("table", whole.c_str()); text != qt(english))
        return text;
    for (const char *phrase : phrases) {
        const auto values = valuesIn(english, phrase);
        if (!values)
            continue;
        QStringList translated;
        for (const std::string_view value : *values)
            translated += devicePhrase(value);
        return filled(QCoreApplication::translate("table", phrase), translated);
    }
    return qt(english);
}

} // namespace mb
