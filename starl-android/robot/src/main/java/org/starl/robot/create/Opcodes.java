package org.starl.robot.create;

/**
 * The first bytes of commands. Numbers of two bytes are signed, high byte first.
 *
 * <pre>
 * opcode             data bytes                                           modes       in
 * 7   reset          none                                                 any         Create 2
 * 128 start          none                                                 any         both
 * 129 baud           code 0-11                                            any         both
 * 130 control        none; as 131                                         not off     both
 * 131 safe           none                                                 not off     both
 * 132 full           none                                                 not off     both
 * 137 drive          speed mm/s +-500 (2), radius mm +-2000 (2):          safe, full  both
 *                    32767 or -32768 straight, 1 spin left, -1 spin right
 * 139 LEDs           bits, power colour 0 green-255 red, intensity        safe, full  both
 * 140 song           number, notes n 1-16, n times (note 31-127, 1/64 s)  not off     both
 * 141 play           number                                               safe, full  both
 * 142 sensors        packet                                               not off     both
 * 145 drive direct   right wheel mm/s +-500 (2), left wheel (2)           safe, full  both
 * 146 drive PWM      right +-255 (2), left (2)                            safe, full  Create 2
 * 148 stream         n, n packets; a frame every 15 ms                    not off     both
 * 149 query list     n, n packets; once                                   not off     both
 * 150 pause/resume   0 pause, 1 resume                                    not off     both
 * 173 stop           none; to off                                         not off     Create 2
 * </pre>
 *
 * <p>{@link CommandParser} has the lengths of the others (demonstrations, motors of brushes, the cargo
 * bay, scripts, displays, schedules): of these the simulated robot obeys only changes of its mode.
 */
final class Opcodes {

  static final int RESET = 7;
  static final int START = 128;
  static final int BAUD = 129;
  static final int CONTROL = 130;
  static final int SAFE = 131;
  static final int FULL = 132;
  static final int POWER = 133;
  static final int SPOT = 134;
  static final int CLEAN = 135;
  static final int DEMO = 136;
  static final int DRIVE = 137;
  static final int LEDS = 139;
  static final int SONG = 140;
  static final int PLAY = 141;
  static final int SENSORS = 142;
  static final int DOCK = 143;
  static final int DRIVE_DIRECT = 145;
  static final int DRIVE_PWM = 146;
  static final int STREAM = 148;
  static final int QUERY_LIST = 149;
  static final int PAUSE_RESUME = 150;
  static final int SCRIPT = 152;
  static final int STOP = 173;

  /** Special values of the radius of opcode 137. */
  static final int STRAIGHT = -32768;

  static final int STRAIGHT_TOO = 32767;
  static final int SPIN_LEFT = 1;
  static final int SPIN_RIGHT = -1;

  private Opcodes() {}
}
