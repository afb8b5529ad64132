package org.starl.robot.create;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.time.Time;

/**
 * The driver as a state machine without threads: received bytes, commands and times in, bytes out.
 * Times never decrease. {@link #advance} must be called at least every {@link #TICK_NS}, and after
 * every call that changes the state.
 *
 * <p>On a new link the driver stops and starts the robot (128), brings it into its mode (131, 132), and
 * requests a stream (148). Then the stream's frames decide whether the wheels may turn.
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

  /** Period of the repeated light: a robot that enters a mode forgets it. */
  static final long LIGHT_NS = 500 * NS_PER_MS;

  /** Two frames: odometry of less is too coarse for a speed. */
  private static final long SPEED_NS = 2 * Packets.STREAM_PERIOD_MS * NS_PER_MS;

  /** The robot's lights are its own until the program sets one. */
  private static final int LIGHT_UNSET = -1;

  /** Sends bytes to the robot. */
  interface Line {
    /**
     * Sends one command. Wheel speeds replace those that were sent last, if these still wait.
     *
     * @return false if the queue is full: the driver sends newer bytes later
     */
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
  private final DriveGate gate;
  private final ReactionMeter reaction;

  private Step step = Step.NO_LINK;
  private long dueNs;
  private long openedNs;
  private long endingNs;
  private long startedNs;
  private long lastFrameNs = Long.MIN_VALUE;
  private long heardNs = Long.MIN_VALUE;
  private CreateSensors sensors = CreateSensors.NONE;
  private Wheelbase.@Nullable TravelReceiver odometer;
  private long clearSinceNs;

  private int sentRight;
  private int sentLeft;
  private long sentNs = Long.MIN_VALUE;
  private long modeSentNs = Long.MIN_VALUE;
  private int lightRgb = LIGHT_UNSET;
  private long lightSentNs = Long.MIN_VALUE;
  private long nowNs;

  private double travelMm;
  private long travelNs;

  private long starts;
  private long recoveries;
  private long linksLost;

  CreateProtocol(CreateSettings settings, Line line) {
    this.settings = settings;
    this.line = line;
    packets = CreateSensors.packets(settings.model());
    decoder = new StreamDecoder(settings.model(), packets);
    meter = new TravelMeter(settings.model());
    reaction = new ReactionMeter(settings.tellAfterMs());
    gate = new DriveGate(settings.commandTimeoutMs(), settings.positionTimeoutMs());
  }

  void linkOpened(long atNs) {
    nowNs = atNs;
    step = Step.START;
    dueNs = atNs;
    openedNs = atNs;
    decoder.reset();
    meter.lose();
    if (odometer != null) {
      odometer.lost();
    }
    lastFrameNs = Long.MIN_VALUE;
  }

  /** Returns whether the robot sent sensor frames over the lost link. */
  boolean linkLost(long atNs) {
    nowNs = atNs;
    boolean hadFrames = step != Step.NO_LINK && lastFrameNs != Long.MIN_VALUE;
    if (step != Step.NO_LINK) {
      linksLost++;
      step = Step.NO_LINK;
    }
    return hadFrames;
  }

  /** Whether the open link has had no sensor frames for too long. */
  boolean isLinkDead(long atNs) {
    long limitMs = settings.linkTimeoutMs();
    return step != Step.NO_LINK
        && (lastFrameNs == Long.MIN_VALUE
            ? atNs - openedNs > Math.max(limitMs, CreateSettings.OPEN_MS) * NS_PER_MS
            : atNs - lastFrameNs > limitMs * NS_PER_MS);
  }

  /** For how long there have been no sensor frames, over all links; 0 before the first. */
  long silentNs(long atNs) {
    return heardNs == Long.MIN_VALUE ? 0 : atNs - heardNs;
  }

  void received(byte[] bytes, int length, long atNs) {
    nowNs = atNs;
    decoder.accept(bytes, length, this::frame);
  }

  /** The program's command; ignored if the program has not been informed of a bump yet. */
  void drive(WheelCommand command, long atNs) {
    nowNs = atNs;
    gate.drive(command, atNs);
  }

  /** A fix that was measured at {@code fixNs}. */
  void fixed(long fixNs, long atNs) {
    nowNs = atNs;
    gate.fixed(fixNs, atNs);
  }

  /** Only a fix that is measured from now on counts: another thread may still pass an older one. */
  void doubted(long atNs) {
    gate.doubted(atNs);
  }

  void onTravel(Wheelbase.TravelReceiver receiver) {
    odometer = receiver;
  }

  void emergencyStop(boolean isOn) {
    gate.emergencyStop(isOn);
  }

  /** The program's light; see {@link Commands#powerLight}. */
  void light(int rgb) {
    lightRgb = rgb;
    lightSentNs = Long.MIN_VALUE;
  }

  /** Whether the strand must be informed about bumps. */
  boolean mustInform() {
    return gate.mustInform();
  }

  /** Informs the strand; returns the bumps that it sees until the next call. */
  Bumps inform() {
    return gate.inform();
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
      shine();
    }
  }

  /** Commands the robot to stop and to be passive, again and again until it confirms that. */
  void end(long atNs) {
    nowNs = atNs;
    if (lightRgb != LIGHT_UNSET) {
      line.send(Commands.powerLight(0));
    }
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

  /** A line about the reaction of the wheels. */
  String reaction() {
    return reaction.summary();
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
    boolean hasFrames = step == Step.RUNNING && isWithin(lastFrameNs, settings.sensorTimeoutMs());
    Set<CreateHold> holds = gate.holds(nowNs);
    DriveGate.add(holds, step == Step.NO_LINK, CreateHold.NO_LINK);
    DriveGate.add(holds, step != Step.NO_LINK && !hasFrames, CreateHold.NO_SENSORS);
    DriveGate.add(holds, hasFrames && sensors.mode() != settings.mode(), CreateHold.NOT_IN_MODE);
    DriveGate.add(holds, sensors.wheelDrop(), CreateHold.WHEEL_DROP);
    DriveGate.add(holds, sensors.cliff(), CreateHold.CLIFF);
    return holds;
  }

  private boolean isWithin(long sinceNs, long ms) {
    return DriveGate.isWithin(nowNs, sinceNs, ms);
  }

  private void frame(StreamDecoder frame) {
    lastFrameNs = nowNs;
    heardNs = nowNs;
    sensors = CreateSensors.of(frame, meter.add(frame));
    Bumps now = sensors.bumps();
    if (odometer != null) {
      int mmPerS = Math.max(Math.abs(sentLeft), Math.abs(sentRight));
      odometer.lifted(sensors.wheelDrop());
      odometer.travelled(nowNs, sensors.travel(), mmPerS, now.any());
    }
    if (sensors.forbidsSafeMode() || sensors.mode() == settings.mode()) {
      clearSinceNs = nowNs;
    }
    gate.bumped(sensors.bumps());
    measureReaction();
  }

  private void measureReaction() {
    double forwardMm = sensors.travel().forwardMm();
    if (nowNs - travelNs >= SPEED_NS) {
      reaction.odometry((forwardMm - travelMm) / Time.seconds(nowNs - travelNs), nowNs);
      travelMm = forwardMm;
      travelNs = nowNs;
    }
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
      case NO_LINK, RUNNING -> throw new IllegalStateException("no command is due: " + step);
    }
    dueNs = nowNs + (step == Step.ENDING ? HEARTBEAT_NS : MODE_GAP_NS);
  }

  /** Brings the robot back into its mode after the cause of the change has been absent long enough. */
  private void keepMode() {
    if (!isWithin(lastFrameNs, settings.sensorTimeoutMs())
        || sensors.mode() == settings.mode()
        || holds().contains(CreateHold.EMERGENCY_STOP)
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
    WheelCommand allowed = gate.allowed(holds(), axleMm, settings.maxWheelMmPerS());
    int rightMmPerS = (int) Math.rint(allowed.rightMmPerS(axleMm));
    int leftMmPerS = (int) Math.rint(allowed.leftMmPerS(axleMm));
    if (rightMmPerS != sentRight
        || leftMmPerS != sentLeft
        || sentNs == Long.MIN_VALUE
        || nowNs - sentNs >= HEARTBEAT_NS) {
      sendWheels(rightMmPerS, leftMmPerS);
    }
  }

  private void shine() {
    boolean isDue = lightSentNs == Long.MIN_VALUE || nowNs - lightSentNs >= LIGHT_NS;
    if (lightRgb != LIGHT_UNSET && isDue && line.send(Commands.powerLight(lightRgb))) {
      lightSentNs = nowNs;
    }
  }

  private void sendWheels(int rightMmPerS, int leftMmPerS) {
    if (line.send(Commands.driveDirect(rightMmPerS, leftMmPerS))) {
      sentRight = rightMmPerS;
      sentLeft = leftMmPerS;
      sentNs = nowNs;
      reaction.sent((rightMmPerS + leftMmPerS) / 2.0, nowNs);
    }
  }
}
