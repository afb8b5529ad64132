package org.starl.robot.optitrack;

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
 * The client's side of NatNet: connects, and again when the server falls silent; learns version and
 * models; asks for the server's clock; keeps a unicast stream alive; makes fixes of frames.
 *
 * <p>Pure and driven by the clock: no socket, no thread. One caller at a time.
 */
final class NatNetProtocol {

  static final long RETRY_NS = 500_000_000;
  static final long KEEP_ALIVE_NS = 1_000_000_000;
  static final long ECHO_NS = 1_000_000_000;
  static final long FIRST_ECHO_NS = 100_000_000;
  static final long SILENCE_NS = 3_000_000_000L;

  /** So many answers about the clock are fetched quickly. */
  private static final int FIRST_ECHOES = 10;

  /** The payload of a connect message of version 4: a name, versions, options, padding. */
  private static final int CONNECT_BYTES = 270;

  /** A body's mean error is no more: a metre. */
  private static final double MOST_MEAN_ERROR_M = 1;

  private static final double MM_PER_M = 1000;

  private final NatNetSettings settings;
  private final Tally tally;
  private final Consumer<byte[]> toServer;
  private final Consumer<List<TrackedBody>> bodies;
  private final LittleEndianWriter out = new LittleEndianWriter();
  private final ServerTime time;
  private final Map<Integer, Long> newestNs = new LinkedHashMap<>();
  private final TreeSet<String> wanted = new TreeSet<>();

  private @Nullable ServerInfo server;
  private Models models = Models.NONE;
  private boolean wantsModels = true;
  private long heardNs;
  private long framedNs;
  private long connectAtNs = Long.MIN_VALUE;
  private long modelsAtNs;
  private long keepAliveAtNs;
  private long echoAtNs;
  private long echoSentNs;
  private int echoes;

  /**
   * @param toServer sends a datagram to the server's command port
   * @param bodies takes what each frame says of the bodies that have names
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

  /** Somebody follows the body of this name: its absence is told. */
  void want(String name, long nowNs) {
    wanted.add(name);
    if (models != Models.NONE) {
      checkWanted(name, nowNs);
    }
  }

  boolean isConnected() {
    return server != null;
  }

  /** Sends what is due; to be called every few tens of milliseconds. */
  void tick(long nowNs) {
    if (server != null && nowNs - heardNs > SILENCE_NS) {
      tally.warnOnce("silent", "the NatNet server has fallen silent: connecting again", nowNs);
      server = null;
    }
    if (server == null) {
      if (nowNs >= connectAtNs) {
        connectAtNs = nowNs + RETRY_NS;
        toServer.accept(connect());
      }
      return;
    }
    if (nowNs - framedNs > SILENCE_NS && nowNs >= connectAtNs) {
      // A server that was started anew answers, but streams to nobody that has not connected.
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
      toServer.accept(out.begin(Message.ECHO_REQUEST).i64(nowNs).end());
    }
  }

  /** A datagram from the server. */
  void received(byte[] bytes, int length, long nowNs) {
    LittleEndianReader in = Message.payload(bytes, length);
    int id = Message.id(bytes, length);
    if (in.failed()) {
      tally.drop(FeedDrop.MALFORMED, "a datagram of " + length + " bytes is cut off", nowNs);
      return;
    }
    boolean isSound =
        switch (id) {
          case Message.SERVER_INFO -> introduced(ServerInfo.parse(in), nowNs);
          case Message.MODELS -> described(in, nowNs);
          case Message.FRAME -> frame(in, nowNs);
          case Message.ECHO_RESPONSE -> answered(in, nowNs);
          case Message.TEXT, Message.RESPONSE, Message.UNRECOGNIZED -> true;
          default -> unknown("message number " + id, nowNs);
        };
    if (isSound) {
      heardNs = nowNs;
    } else {
      tally.drop(
          FeedDrop.MALFORMED,
          "message " + id + " of " + length + " bytes is none of NatNet " + version(),
          nowNs);
    }
  }

  // With no version of its own here, the server streams in its newest, and says which that is.
  private byte[] connect() {
    int nameBytes = 256;
    out.begin(Message.CONNECT).fixedName("Ping", nameBytes);
    return out.zeros(CONNECT_BYTES - nameBytes).end();
  }

  private boolean introduced(@Nullable ServerInfo info, long nowNs) {
    if (info == null) {
      return false;
    }
    if (info.version().compareTo(NatNetVersion.V3_0) < 0) {
      return unknown(
          info.name() + " speaks NatNet " + info.version() + ": expected 3.0 or later", nowNs);
    }
    if (info.equals(server)) {
      return true;
    }
    warn(info, nowNs);
    tally.info("connected to " + printable(info.name()) + ", NatNet " + info.version(), nowNs);
    server = info;
    models = Models.NONE;
    wantsModels = true;
    framedNs = nowNs;
    modelsAtNs = nowNs;
    keepAliveAtNs = nowNs;
    echoAtNs = nowNs;
    echoes = 0;
    time.begin(info.ticksPerS());
    return true;
  }

  private void warn(ServerInfo info, long nowNs) {
    if (info.ticksPerS() > 0 && info.isMulticast() != (settings.group() != null)) {
      String theirs = info.isMulticast() ? "multicast" : "unicast";
      String ours = settings.group() != null ? "multicast" : "unicast";
      tally.warnOnce("cast", "the server streams " + theirs + ", the settings say " + ours, nowNs);
    }
    if (info.version().compareTo(NatNetVersion.V4_2) > 0) {
      tally.warnOnce(
          "newer",
          "NatNet " + info.version() + " is newer than 4.2: what is not known of it is skipped",
          nowNs);
    }
  }

  private boolean described(LittleEndianReader in, long nowNs) {
    if (server == null) {
      return early(nowNs);
    }
    Models newModels = Models.parse(in, server.version());
    if (newModels == null) {
      return false;
    }
    models = newModels;
    wantsModels = false;
    newestNs.keySet().retainAll(models.ids());
    wanted.forEach(name -> checkWanted(name, nowNs));
    tally.warnOnce("models", "the server's rigid bodies: " + printable(models.toString()), nowNs);
    if (!models.isWhole()) {
      tally.warnOnce("unknown model", "some descriptions could not be read", nowNs);
    }
    return true;
  }

  private boolean answered(LittleEndianReader in, long nowNs) {
    long sentNs = in.i64();
    long ticks = in.i64();
    if (in.failed()) {
      return false;
    }
    // Only the answer to the last question counts, and once.
    if (server != null && sentNs == echoSentNs && echoSentNs != 0) {
      time.answered(sentNs, ticks, nowNs);
      echoSentNs = 0;
      echoes++;
    }
    return true;
  }

  private boolean frame(LittleEndianReader in, long nowNs) {
    if (server == null) {
      return early(nowNs);
    }
    MocapFrame frame = FrameParser.parse(in, server.version());
    if (frame == null) {
      return false;
    }
    framedNs = nowNs;
    wantsModels |= frame.hasNewModels();
    TimeSpan when = time.measured(frame, nowNs);
    if (when == null) {
      return early(nowNs);
    }
    if (when.earliestNs() > when.latestNs()) {
      tally.drop(FeedDrop.IMPLAUSIBLE, "a frame says that it was not measured yet", nowNs);
    } else if (nowNs - when.middleNs() > settings.bounds().maxAgeNs()) {
      tally.drop(FeedDrop.STALE, "a frame was measured too long ago", nowNs);
    } else {
      bodies.accept(tracked(frame.bodies(), when, nowNs));
    }
    return true;
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
    Long before = newestNs.get(state.id());
    if (before != null && when.middleNs() <= before) {
      tally.drop(FeedDrop.OUTDATED, "a newer fix of " + printable(name) + " came before", nowNs);
      return null;
    }
    newestNs.put(state.id(), when.middleNs());
    tally.fixed();
    return settings.bounds().ofMarkers(pose, MM_PER_M * state.meanErrorM(), when);
  }

  private void checkWanted(String name, long nowNs) {
    if (!models.has(name)) {
      tally.warnOnce(
          "no " + name,
          "no rigid body has the name " + name + ": there are " + printable(models.toString()),
          nowNs);
    }
  }

  private boolean early(long nowNs) {
    tally.drop(FeedDrop.EARLY, "a message came before the server and its clock were known", nowNs);
    return true;
  }

  private boolean unknown(String what, long nowNs) {
    tally.drop(FeedDrop.UNKNOWN, printable(what), nowNs);
    return true;
  }

  private String version() {
    return server == null ? "any version" : server.version().toString();
  }

  /** On one line of a terminal, whatever bytes came. */
  private static String printable(String text) {
    int shown = Math.min(text.length(), 300);
    StringBuilder line = new StringBuilder(shown);
    for (int i = 0; i < shown; i++) {
      char c = text.charAt(i);
      line.append(Character.isISOControl(c) || c == 0x2028 || c == 0x2029 ? '?' : c);
    }
    return line.toString();
  }
}
