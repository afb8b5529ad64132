package org.starl.robot.create;

import java.util.ArrayList;
import java.util.List;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;

/**
 * Driver and robot on one bench in virtual time, joined by a line with its true speed: a byte takes
 * ten bits. The program, where it runs, repeats its command every 60 ms and has fixes every 100 ms.
 */
final class Bench {

  static final long MS = 1_000_000;
  private static final long STEP_NS = MS / 2;

  final CreateModel model;
  final FloorBody body = new FloorBody();
  final SimulatedCreate robot;
  final CreateProtocol driver;
  final List<Bumps> heard = new ArrayList<>();

  /** What the program wants; it repeats it. */
  WheelCommand wanted = WheelCommand.STOP;

  boolean isProgramAlive = true;
  boolean isStrandBusy;
  boolean hasFixes = true;
  boolean isRobotHeard = true;
  boolean isRobotHearing = true;
  long nowNs;

  private final Wire toRobot;
  private final Wire toDriver;

  Bench(CreateSettings settings) {
    model = settings.model();
    toRobot = new Wire(model.baud());
    toDriver = new Wire(model.baud());
    robot = new SimulatedCreate(model, body, bytes -> toDriver.put(bytes, nowNs));
    driver =
        new CreateProtocol(
            settings,
            bytes -> {
              toRobot.put(bytes, nowNs);
              return true;
            });
  }

  static CreateSettings settings(CreateModel model, OiMode mode, long positionTimeoutMs) {
    return new CreateSettings(model, mode, 300, positionTimeoutMs, 100, 500, 3000, 200, 500, 500);
  }

  static Bench of(CreateModel model) {
    return new Bench(CreateSettings.of(model));
  }

  /** With a robot that is ready to be driven. */
  static Bench ready(CreateModel model) {
    Bench bench = of(model);
    bench.driver.linkOpened(0);
    bench.runMs(400);
    return bench;
  }

  /** With a robot that drives straight ahead at 250 mm/s. */
  static Bench driving(CreateModel model) {
    Bench bench = ready(model);
    bench.wanted = new WheelCommand(250, 0);
    bench.runMs(200);
    return bench;
  }

  void runMs(long ms) {
    for (long end = nowNs + ms * MS; nowNs < end; nowNs += STEP_NS) {
      step();
    }
  }

  /** Runs until the wheels stand; how long that took in ms, -1 if it takes more than {@code most}. */
  double msUntilItStands(long most) {
    long from = nowNs;
    while (!body.stands()) {
      if (nowNs - from > most * MS) {
        return -1;
      }
      step();
      nowNs += STEP_NS;
    }
    return (nowNs - from) / (double) MS;
  }

  private void step() {
    boolean isProgramDue = nowNs % (60 * MS) == 0;
    if (isProgramAlive && !isStrandBusy && isProgramDue) {
      driver.drive(wanted, nowNs);
    }
    if (hasFixes && nowNs % (100 * MS) == 0) {
      driver.fixed(nowNs, nowNs);
    }
    byte[] commands = toRobot.take(nowNs);
    if (isRobotHearing) {
      robot.receive(commands, commands.length, nowNs);
    } else {
      robot.advance(nowNs);
    }
    byte[] said = toDriver.take(nowNs);
    if (said.length > 0 && isRobotHeard) {
      driver.received(said, said.length, nowNs);
      driver.advance(nowNs);
    }
    if (nowNs % CreateProtocol.TICK_NS == 0) {
      driver.advance(nowNs);
    }
    if (!isStrandBusy && driver.mustInform()) {
      heard.add(driver.inform());
    }
  }

  /** One direction of a serial line. */
  private static final class Wire {
    private final long byteNs;
    private final List<Byte> bytes = new ArrayList<>();
    private final List<Long> arriveNs = new ArrayList<>();
    private long freeNs;

    Wire(int baud) {
      byteNs = 10_000_000_000L / baud;
    }

    void put(byte[] added, long nowNs) {
      freeNs = Math.max(freeNs, nowNs);
      for (byte b : added) {
        freeNs += byteNs;
        bytes.add(b);
        arriveNs.add(freeNs);
      }
    }

    byte[] take(long nowNs) {
      int count = 0;
      while (count < bytes.size() && arriveNs.get(count) <= nowNs) {
        count++;
      }
      byte[] taken = new byte[count];
      for (int i = 0; i < count; i++) {
        taken[i] = bytes.get(i);
      }
      bytes.subList(0, count).clear();
      arriveNs.subList(0, count).clear();
      return taken;
    }
  }
}
