package org.starl.robot.create;

import static org.starl.time.Time.NS_PER_MS;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;

/**
 * The driver without threads: (call, bytes or time) to bytes. Every call has the time, which never
 * decreases; {@link #advance} must be called at least every {@link #TICK_NS}, and after every call
 * that changes something.
 *
 * <p>On a new link the robot is stopped and started (128), brought into its mode (131, 132), and
 * asked for a stream (148). After that its frames decide: a missing one, another mode, a sensor.
 */
final class CreateProtocol {

  /** Longest time between two calls of {@link #advance}, which checks the timeouts. */
  static final long TICK_NS = 10 * NS_PER_MS;

  /** Period of repeated wheel speeds, in case noise changed them: commands have no checksum. */
  static final long HEARTBEAT_NS = 50 * NS_PER_MS;

  /** Time between two commands that change the mode; below 20 ms robots miss them. */
  static final long MODE_GAP_NS = 100 * NS_PER_MS;

  /** A robot that streams nothing for this time is started again. */
  static final long RESTART_NS = 1000 * NS_PER_MS;

  /** Takes the bytes for the robot. */
  interface Line {
    /** False if there is no room now: they will be made again. */
    boolean send(byte[] bytes);
  }

  /** The stage of the robot's start. */
  private enum Step {
    NO_LINK,
    START,
    MODE,
    STREAM,
    RUNNING,
    ENDING
  }

  private final CreateSettings settings;
  private final Line line;
  private final StreamDecoder decoder;
  private final TravelMeter meter;
  private final int[] packets;

  private Step step = Step.NO_LINK;
  private long dueNs;
  private long openedNs;
  private long endingNs;
  private long startedNs;
  private long lastFrameNs = Long.MIN_VALUE;
  private long lastFixNs = Long.MIN_VALUE;
  private CreateSensors sensors = CreateSensors.NONE;
  private long clearSinceNs;

  private WheelCommand wanted = WheelCommand.STOP;
  private long wantedNs = Long.MIN_VALUE;
  private boolean isEmergency;
  private Bumps toldBumps = Bumps.NONE;
  private Bumps untoldBumps = Bumps.NONE;
  private boolean isBumpUntold;

  private int sentRight;
  private int sentLeft;
  private long sentNs = Long.MIN_VALUE;
  private long modeSentNs = Long.MIN_VALUE;
  private long nowNs;

  private long starts;
  private long recoveries;
  private long linksLost;

  CreateProtocol(CreateSettings settings, Line line) {
    this.settings = settings;
    this.line = line;
    packets = CreateSensors.packets(settings.model());
    decoder = new StreamDecoder(settings.model(), packets);
    meter = new TravelMeter(settings.model());
  }

  void linkOpened(long atNs) {
    nowNs = atNs;
    step = Step.START;
    dueNs = atNs;
    openedNs = atNs;
    decoder.reset();
    meter.lose();
    lastFrameNs = Long.MIN_VALUE;
  }

  /** Returns whether there was a link on which the robot was heard. */
  boolean linkLost(long atNs) {
    nowNs = atNs;
    boolean wasHeard = step != Step.NO_LINK && lastFrameNs != Long.MIN_VALUE;
    if (step != Step.NO_LINK) {
      linksLost++;
      step = Step.NO_LINK;
    }
    return wasHeard;
  }

  /** Whether there is a link without sensor frames for too long. */
  boolean isLinkDead(long atNs) {
    return step != Step.NO_LINK
        && atNs - Math.max(openedNs, lastFrameNs) > settings.linkTimeoutMs() * NS_PER_MS;
  }

  void received(byte[] bytes, int length, long atNs) {
    nowNs = atNs;
    decoder.accept(bytes, length, this::frame);
  }

  /** The program's command; ignored if the program has not been informed of a bump yet. */
  void drive(WheelCommand command, long atNs) {
    nowNs = atNs;
    if (!isBumpUntold) {
      wanted = command;
      wantedNs = atNs;
    }
  }

  /** A fix that was true at {@code fixNs}. */
  void fixed(long fixNs, long atNs) {
    nowNs = atNs;
    lastFixNs = Math.max(lastFixNs, Math.min(fixNs, atNs));
  }

  void emergencyStop(boolean isOn) {
    isEmergency = isOn;
    if (isOn) {
      wanted = WheelCommand.STOP;
    }
  }

  /** Whether the strand must be informed about bumps. */
  boolean hasNews() {
    return isBumpUntold || untoldBumps != toldBumps;
  }

  /** Informs the strand: the bumps that it sees until the next call. */
  Bumps tell() {
    toldBumps = untoldBumps;
    isBumpUntold = false;
    untoldBumps = sensors.bumps();
    return toldBumps;
  }

  void advance(long atNs) {
    nowNs = atNs;
    if (step == Step.NO_LINK) {
      return;
    }
    if (step == Step.RUNNING) {
      keepMode();
    }
    if (step == Step.RUNNING && atNs - Math.max(startedNs, lastFrameNs) > RESTART_NS) {
      step = Step.START;
      dueNs = atNs;
    }
    if (step != Step.RUNNING) {
      nextStep();
    } else {
      turnWheels();
    }
  }

  /** From now on commands the robot to stop and to be passive, until it confirms that. */
  void end(long atNs) {
    nowNs = atNs;
    if (step != Step.NO_LINK) {
      step = Step.ENDING;
      dueNs = atNs;
      endingNs = atNs;
    }
  }

  /** Whether the robot has confirmed the end, or there is no link. */
  boolean hasEnded() {
    return step == Step.NO_LINK
        || (step == Step.ENDING && lastFrameNs > endingNs && sensors.mode() == OiMode.PASSIVE);
  }

  CreateStatus status() {
    return new CreateStatus(
        List.copyOf(holds()),
        sensors,
        decoder.frames(),
        decoder.badChecksums(),
        decoder.dropped(),
        starts,
        recoveries,
        linksLost);
  }

  Set<CreateHold> holds() {
    boolean isHeard = step == Step.RUNNING && isWithin(lastFrameNs, settings.sensorTimeoutMs());
    // A program that wants the robot to stand need not repeat that.
    boolean isDriving = !wanted.isStop();
    boolean needsFixes = settings.positionTimeoutMs() > 0;
    Set<CreateHold> holds = EnumSet.allOf(CreateHold.class);
    holds.removeIf(hold ->
        !switch (hold) {
          case EMERGENCY_STOP -> isEmergency;
          case NO_LINK -> step == Step.NO_LINK;
          case NO_SENSORS -> step != Step.NO_LINK && !isHeard;
          case NOT_IN_MODE -> isHeard && sensors.mode() != settings.mode();
          case WHEEL_DROP -> sensors.wheelDrop();
          case BUMP_UNTOLD -> isBumpUntold;
          case STALE_COMMAND -> isDriving && !isWithin(wantedNs, settings.commandTimeoutMs());
          case STALE_POSITION ->
              isDriving && needsFixes && !isWithin(lastFixNs, settings.positionTimeoutMs());
          case CLIFF -> sensors.cliff();
          case BUMP -> sensors.bumps().any();
        });
    return holds;
  }

  private boolean isWithin(long sinceNs, long ms) {
    return sinceNs != Long.MIN_VALUE && nowNs - sinceNs <= ms * NS_PER_MS;
  }

  private void frame(StreamDecoder frame) {
    lastFrameNs = nowNs;
    Bumps before = sensors.bumps();
    sensors = CreateSensors.of(frame, meter.add(frame));
    Bumps now = sensors.bumps();
    if (sensors.forbidsSafeMode() || sensors.mode() == settings.mode()) {
      clearSinceNs = nowNs;
    }
    if (isMore(before, now)) {
      // The program gave its command before it knew of this bump.
      isBumpUntold = true;
      wanted = WheelCommand.STOP;
      untoldBumps = both(untoldBumps, now);
    } else if (!isBumpUntold) {
      untoldBumps = now;
    }
  }

  private static boolean isMore(Bumps before, Bumps now) {
    return !both(before, now).equals(before);
  }

  private static Bumps both(Bumps one, Bumps other) {
    return one == other || other == Bumps.NONE ? one : one == Bumps.NONE ? other : Bumps.BOTH;
  }

  private void nextStep() {
    if (nowNs < dueNs) {
      return;
    }
    switch (step) {
      case START -> {
        line.send(Commands.flush());
        sendWheels(0, 0);
        line.send(Commands.start());
        starts++;
        startedNs = nowNs;
        decoder.reset();
        step = Step.MODE;
      }
      case MODE -> {
        sendMode();
        step = Step.STREAM;
      }
      case STREAM -> {
        sendWheels(0, 0);
        line.send(Commands.stream(packets));
        step = Step.RUNNING;
      }
      case ENDING -> {
        sendWheels(0, 0);
        line.send(Commands.start());
      }
      case NO_LINK, RUNNING -> throw new IllegalStateException("nothing to send: " + step);
    }
    dueNs = nowNs + (step == Step.ENDING ? HEARTBEAT_NS : MODE_GAP_NS);
  }

  /** Brings the robot back into its mode when the cause has been absent for long enough. */
  private void keepMode() {
    if (!isWithin(lastFrameNs, settings.sensorTimeoutMs())
        || sensors.mode() == settings.mode()
        || isEmergency
        || isWithin(clearSinceNs, settings.recoverAfterMs())
        || isWithin(modeSentNs, 2 * MODE_GAP_NS / NS_PER_MS)) {
      return;
    }
    recoveries++;
    if (sensors.mode() == OiMode.OFF || sensors.mode() == OiMode.UNKNOWN) {
      step = Step.START;
      dueNs = nowNs;
    } else {
      sendWheels(0, 0);
      sendMode();
    }
  }

  private void sendMode() {
    line.send(Commands.mode(settings.mode()));
    modeSentNs = nowNs;
  }

  private void turnWheels() {
    double axleMm = settings.model().axleMm();
    WheelCommand left = WheelLimit.under(holds(), wanted);
    double factor = WheelLimit.factor(left, axleMm, settings.maxWheelMmPerS());
    int rightMmPerS = (int) Math.rint(left.rightMmPerS(axleMm) * factor);
    int leftMmPerS = (int) Math.rint(left.leftMmPerS(axleMm) * factor);
    if (rightMmPerS != sentRight
        || leftMmPerS != sentLeft
        || sentNs == Long.MIN_VALUE
        || nowNs - sentNs >= HEARTBEAT_NS) {
      sendWheels(rightMmPerS, leftMmPerS);
    }
  }

  private void sendWheels(int rightMmPerS, int leftMmPerS) {
    if (line.send(Commands.driveDirect(rightMmPerS, leftMmPerS))) {
      sentRight = rightMmPerS;
      sentLeft = leftMmPerS;
      sentNs = nowNs;
    }
  }
}
