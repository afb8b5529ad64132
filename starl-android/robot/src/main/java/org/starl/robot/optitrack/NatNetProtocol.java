package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_MS;
import static org.starl.time.Time.NS_PER_S;

import java.nio.BufferUnderflowException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;

/**
 * The client's side of NatNet: connects, and reconnects when the server is silent; gets the server's
 * version, models and clock; keeps a unicast stream alive; converts frames to fixes.
 *
 * <p>A message that changes what the server is may be forged, so it is doubted: another server's description
 * counts only after {@link #SILENCE_NS} without frames that the known one explains, and new models are asked for again until all
 * answers were equal for {@link #CONFIRM_NS}; meanwhile the bodies that they name otherwise have no fixes.
 *
 * <p>Pure and driven by the clock: no socket, no thread. One caller at a time.
 */
final class NatNetProtocol {

  static final long RETRY_NS = 500 * NS_PER_MS;
  static final long KEEP_ALIVE_NS = NS_PER_S;
  static final long ECHO_NS = NS_PER_S;
  static final long FIRST_ECHO_NS = 100 * NS_PER_MS;
  static final long SILENCE_NS = 3 * NS_PER_S;

  /** Two requests of models or more are answered in this time. */
  static final long CONFIRM_NS = 1100 * NS_PER_MS;

  /** Number of clock answers that are requested at the faster rate. */
  private static final int FIRST_ECHOES = 10;

  /** The payload of a connect message of version 4: a name, versions, options, padding. */
  private static final int CONNECT_BYTES = 270;

  /** Largest plausible mean error of a body. */
  private static final double MOST_MEAN_ERROR_M = 1;

  private static final double MM_PER_M = 1000;

  private final NatNetSettings settings;
  private final Tally tally;
  private final Consumer<byte[]> toServer;
  private final Consumer<List<TrackedBody>> bodies;
  private final LittleEndianWriter out = new LittleEndianWriter();
  private final ServerTime time;
  private final Map<String, PoseGate> gates = new LinkedHashMap<>();
  private final TreeSet<String> wanted = new TreeSet<>();

  private @Nullable ServerInfo server;
  private Models models = Models.NONE;
  private boolean wantsModels = true;
  private Models newestModels = Models.NONE;
  private long sameModelsNs;
  private final TreeSet<Integer> doubted = new TreeSet<>();
  private long lastMessageNs;
  private long lastFrameNs;
  private long connectedNs;
  private long connectAtNs = Long.MIN_VALUE;
  private long modelsAtNs;
  private long keepAliveAtNs;
  private long echoAtNs;
  private long echoSentNs;
  private int echoes;

  /**
   * @param toServer sends a datagram to the server's command port
   * @param bodies takes each frame's bodies that have names
   */
  NatNetProtocol(
      NatNetSettings settings,
      Tally tally,
      Consumer<byte[]> toServer,
      Consumer<List<TrackedBody>> bodies) {
    this.settings = settings;
    this.tally = tally;
    this.toServer = toServer;
    this.bodies = bodies;
    this.time = new ServerTime(settings.bounds());
  }

  Models models() {
    return models;
  }

  /** Logs, now or when the models arrive, if no body has this name. A robot follows that body. */
  void want(String name, long nowNs) {
    wanted.add(name);
    if (models != Models.NONE) {
      checkWanted(name, nowNs);
    }
  }

  boolean isConnected() {
    return server != null;
  }

  /** Whether frames come that can be read and have a plausible time. */
  boolean hasFrames(long nowNs) {
    return server != null && nowNs - lastFrameNs < RETRY_NS && lastFrameNs > connectedNs;
  }

  /** Sends due messages; must be called every few tens of milliseconds. */
  void tick(long nowNs) {
    if (server != null && nowNs - lastMessageNs > SILENCE_NS) {
      tally.warnOnce("silent", "the NatNet server is silent: connecting again", nowNs);
      server = null;
    }
    if (server == null) {
      if (nowNs >= connectAtNs) {
        connectAtNs = nowNs + RETRY_NS;
        toServer.accept(connect());
      }
      return;
    }
    if (nowNs - lastFrameNs > SILENCE_NS && nowNs >= connectAtNs) {
      // A restarted server answers, but streams only to clients that have connected again.
      connectAtNs = nowNs + RETRY_NS;
      wantsModels = true;
      toServer.accept(connect());
    }
    if (wantsModels && nowNs >= modelsAtNs) {
      modelsAtNs = nowNs + RETRY_NS;
      toServer.accept(out.begin(Message.REQUEST_MODELS).end());
    }
    if (settings.group() == null && nowNs >= keepAliveAtNs) {
      keepAliveAtNs = nowNs + KEEP_ALIVE_NS;
      toServer.accept(out.begin(Message.KEEP_ALIVE).end());
    }
    if (nowNs >= echoAtNs) {
      echoAtNs = nowNs + (echoes < FIRST_ECHOES ? FIRST_ECHO_NS : ECHO_NS);
      echoSentNs = nowNs;
      echoes++;
      toServer.accept(out.begin(Message.ECHO_REQUEST).i64(nowNs).end());
    }
  }

  /** A datagram from the server. */
  void received(byte[] bytes, int length, long nowNs) {
    int id = Message.id(bytes, length);
    try {
      LittleEndianReader in = Message.payload(bytes, length);
      switch (id) {
        case Message.SERVER_INFO -> onServerInfo(ServerInfo.parse(in), nowNs);
        case Message.MODELS -> onModels(in, nowNs);
        case Message.FRAME -> onFrame(in, nowNs);
        case Message.ECHO_RESPONSE -> onEcho(in, nowNs);
        case Message.TEXT, Message.RESPONSE, Message.UNRECOGNIZED -> {
          // Proves only that the server runs.
        }
        default -> unknown("message number " + id, nowNs);
      }
      lastMessageNs = nowNs;
    } catch (BufferUnderflowException e) {
      tally.drop(
          FeedDrop.MALFORMED,
          "message " + id + " of " + length + " bytes is cut off, or not of NatNet " + version(),
          nowNs);
    }
  }

  // Without a version in this message the server streams in its newest version, which its answer
  // has.
  private byte[] connect() {
    int nameBytes = 256;
    out.begin(Message.CONNECT).fixedName("Ping", nameBytes);
    return out.zeros(CONNECT_BYTES - nameBytes).end();
  }

  private void onServerInfo(ServerInfo info, long nowNs) {
    if (info.version().compareTo(NatNetVersion.V3_0) < 0) {
      unknown(info.name() + " uses NatNet " + info.version() + ": expected 3.0 or later", nowNs);
      return;
    }
    if (info.equals(server)) {
      return;
    }
    if (server != null && nowNs - lastFrameNs <= SILENCE_NS) {
      boolean isOtherVersion = !info.version().equals(server.version());
      tally.warnOnce(
          isOtherVersion ? "other version" : "other server",
          (isOtherVersion ? "a server of NatNet " + info.version() : "another server")
              + " has described itself, and is not believed while frames come: "
              + printable(info.toString()),
          nowNs);
      return;
    }
    warn(info, nowNs);
    tally.info("connected to " + printable(info.name()) + ", NatNet " + info.version(), nowNs);
    server = info;
    models = Models.NONE;
    newestModels = Models.NONE;
    doubted.clear();
    wantsModels = true;
    lastFrameNs = nowNs;
    connectedNs = nowNs;
    modelsAtNs = nowNs;
    keepAliveAtNs = nowNs;
    echoAtNs = nowNs;
    echoes = 0;
    time.begin(info.ticksPerS());
  }

  private void warn(ServerInfo info, long nowNs) {
    if (info.ticksPerS() > 0 && info.isMulticast() != (settings.group() != null)) {
      String actual = info.isMulticast() ? "multicast" : "unicast";
      String expected = settings.group() != null ? "multicast" : "unicast";
      tally.warnOnce(
          "cast", "the server streams " + actual + ", the settings say " + expected, nowNs);
    }
    if (info.version().compareTo(NatNetVersion.V4_2) > 0) {
      tally.warnOnce(
          "newer",
          "NatNet " + info.version() + " is newer than 4.2: unknown parts are skipped",
          nowNs);
    }
  }

  private void onModels(LittleEndianReader in, long nowNs) {
    if (server == null) {
      early(nowNs);
      return;
    }
    Models sent = Models.parse(in, server.version());
    boolean isFirst = models == Models.NONE;
    models = isFirst ? sent : models;
    if (isFirst || !sent.differences(newestModels).isEmpty()) {
      sameModelsNs = nowNs;
      wantsModels = true;
      doubted.addAll(sent.differences(models));
      newestModels = sent;
    }
    if (!doubted.isEmpty()) {
      tally.warnOnce(
          "other models",
          "the server's rigid bodies differ from those before; asking again: "
              + printable(sent.toString()),
          nowNs);
    }
    if (nowNs - sameModelsNs >= CONFIRM_NS) {
      models = sent;
      wantsModels = false;
      doubted.clear();
    }
    gates.keySet().removeIf(name -> !models.has(name) && !wanted.contains(name));
    wanted.forEach(name -> checkWanted(name, nowNs));
    tally.warnOnce("models", "the server's rigid bodies: " + printable(models.toString()), nowNs);
    if (!models.isWhole()) {
      tally.warnOnce("unknown model", "some descriptions could not be read", nowNs);
    }
  }

  private void onEcho(LittleEndianReader in, long nowNs) {
    long sentNs = in.i64();
    long ticks = in.i64();
    // Each answer to the last request counts: a false one may come first.
    if (server != null && sentNs == echoSentNs && echoes > 0) {
      time.answered(sentNs, ticks, nowNs);
      if (time.isContradicted(nowNs)) {
        tally.warnOnce(
            "clock",
            "answers about the server's clock contradict each other, so no fixes: some are forged, or"
                + " its clock does not run at the rate that it has told",
            nowNs);
      }
    }
  }

  private void onFrame(LittleEndianReader in, long nowNs) {
    if (server == null) {
      early(nowNs);
      return;
    }
    MocapFrame frame = FrameParser.parse(in, server.version());
    wantsModels |= frame.hasNewModels();
    TimeSpan when = time.measured(frame, nowNs);
    if (when == null) {
      early(nowNs);
    } else if (when.earliestNs() > when.latestNs()) {
      tally.drop(FeedDrop.IMPLAUSIBLE, "a frame has a time of measurement in the future", nowNs);
    } else if (nowNs - when.middleNs() > settings.bounds().maxAgeNs()) {
      tally.drop(FeedDrop.STALE, "a frame was measured too long ago", nowNs);
    } else {
      lastFrameNs = nowNs;
      bodies.accept(tracked(frame.bodies(), when, nowNs));
    }
  }

  private List<TrackedBody> tracked(List<RigidBodyState> states, TimeSpan when, long nowNs) {
    List<TrackedBody> found = new ArrayList<>(states.size());
    TreeSet<Integer> seen = new TreeSet<>();
    TreeSet<Integer> twice = new TreeSet<>();
    for (RigidBodyState state : states) {
      if (!seen.add(state.id())) {
        twice.add(state.id());
      }
    }
    for (RigidBodyState state : states) {
      String name = models.name(state.id());
      if (name == null) {
        wantsModels = true;
      } else if (doubted.contains(state.id())) {
        tally.drop(
            FeedDrop.DOUBTED, "the server's models disagree about " + printable(name), nowNs);
      } else if (twice.contains(state.id()) || models.isAmbiguous(name)) {
        tally.drop(
            FeedDrop.AMBIGUOUS, "two rigid bodies are " + printable(name) + state.id(), nowNs);
      } else {
        found.add(new TrackedBody(name, state.id(), fix(state, name, when, nowNs)));
      }
    }
    return found;
  }

  private @Nullable Fix fix(RigidBodyState state, String name, TimeSpan when, long nowNs) {
    if (!state.isTracked()) {
      tally.drop(FeedDrop.LOST, "the cameras have lost " + printable(name), nowNs);
      return null;
    }
    Pose pose = settings.axes().pose(state);
    if (pose == null || !(state.meanErrorM() >= 0 && state.meanErrorM() <= MOST_MEAN_ERROR_M)) {
      tally.drop(
          FeedDrop.IMPLAUSIBLE, printable(name) + " does not stand on a floor: " + state, nowNs);
      return null;
    }
    Fix fix = settings.bounds().ofMarkers(pose, MM_PER_M * state.meanErrorM(), when);
    PoseGate gate = gates.computeIfAbsent(name, body -> new PoseGate(settings.bounds()));
    return tally.admit(gate, name, fix, nowNs) ? fix : null;
  }

  private void checkWanted(String name, long nowNs) {
    if (!models.has(name)) {
      tally.warnOnce(
          "no " + name,
          "no rigid body has the name " + name + ": there are " + printable(models.toString()),
          nowNs);
    }
  }

  private void early(long nowNs) {
    tally.drop(FeedDrop.EARLY, "a message before the server and its clock are known", nowNs);
  }

  private void unknown(String what, long nowNs) {
    tally.drop(FeedDrop.UNKNOWN, printable(what), nowNs);
  }

  private String version() {
    return server == null ? "any version" : server.version().toString();
  }

  /** The text on one line, without control characters. */
  static String printable(String text) {
    int shown = Math.min(text.length(), 300);
    StringBuilder line = new StringBuilder(shown);
    for (int i = 0; i < shown; i++) {
      char c = text.charAt(i);
      line.append(Character.isISOControl(c) || c == 0x2028 || c == 0x2029 ? '?' : c);
    }
    return line.toString();
  }
}
