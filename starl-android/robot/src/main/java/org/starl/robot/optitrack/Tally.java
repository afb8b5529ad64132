package org.starl.robot.optitrack;

import static org.starl.robot.optitrack.NatNetProtocol.printable;
import static org.starl.time.Time.NS_PER_S;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.platform.LogSink;
import org.starl.robot.udp.DropCounts;

/**
 * A feed's counters; logs the first drop for each reason, and the first jump of each episode. One
 * thread at a time.
 */
final class Tally {

  /** An episode of jumps ends after this time without any. */
  static final long EPISODE_NS = 10 * NS_PER_S;

  /** Bodies whose jumps are logged; those of further ones are only counted. */
  private static final int MOST_TOLD = 64;

  /** A robot that follows its own fixes. */
  private record Own(WheelPath path, Runnable onDoubt) {}

  private final LogSink log;
  private final String tag;
  private final DropCounts<FeedDrop> drops = new DropCounts<>(FeedDrop.class);
  private final Set<String> warned = new TreeSet<>();
  private final Map<String, Long> jumpedNs = new TreeMap<>();
  private final Map<String, Long> doubtedNs = new TreeMap<>();
  private final Map<String, Own> own = new TreeMap<>();
  private long received;
  private long fixes;

  Tally(LogSink log, String tag) {
    this.log = log;
    this.tag = tag;
  }

  void received() {
    received++;
  }

  void drop(FeedDrop why, String what, long nowNs) {
    // Early datagrams are normal at a start.
    if (drops.add(why) && why != FeedDrop.EARLY) {
      log.log(nowNs, LogSink.Level.WARN, tag, what + "; further ones are only counted: " + why);
    }
  }

  /**
   * Judges the fixes of this robot by its wheels, too.
   *
   * @param onDoubt called at once when other poses contradict them: the wheels must stop
   */
  void own(String name, WheelPath path, Runnable onDoubt) {
    own.put(name, new Own(path, onDoubt));
  }

  /**
   * Judges a fix; counts it if it is dropped.
   *
   * @param name of the body as it is sent
   * @return whether to use it
   */
  boolean admit(PoseGate gate, String name, Fix fix, long nowNs) {
    Own robot = own.get(name);
    WheelPath path = robot == null ? null : robot.path();
    Fix before = gate.before();
    PoseGate.Verdict verdict = gate.judge(fix, path);
    switch (verdict) {
      case PASSED -> {
        fixes++;
        return true;
      }
      case MOVED -> {
        fixes++;
        warn(printable(name) + " was moved by hand: it is at " + text(fix), nowNs);
        return true;
      }
      case OUTDATED ->
          drop(FeedDrop.OUTDATED, "a newer fix of " + printable(name) + " came before", nowNs);
      case LIFTED -> drops.add(FeedDrop.LIFTED);
      case EARLY -> drops.add(FeedDrop.EARLY);
      case DOUBTED -> drops.add(FeedDrop.DOUBTED);
      case JUMPED, CONTRADICTED -> {
        drops.add(FeedDrop.JUMPED);
        boolean isDoubt = verdict == PoseGate.Verdict.CONTRADICTED && robot != null;
        if (isDoubt && robot != null) {
          robot.onDoubt().run();
        }
        Pose byWheels = path == null ? null : gate.byWheels(fix, path);
        jumped(isDoubt, name, before, fix, byWheels, nowNs);
      }
    }
    return false;
  }

  private void jumped(
      boolean isDoubt,
      String name,
      @Nullable Fix before,
      Fix fix,
      @Nullable Pose byWheels,
      long nowNs) {
    if (!isNewEpisode(isDoubt ? doubtedNs : jumpedNs, name, nowNs)) {
      return;
    }
    String from = before == null ? "the fix before it" : text(before);
    String wheels = byWheels == null ? "" : ", and its wheels say " + PoseGate.text(byWheels);
    if (isDoubt) {
      warn(
          printable(name)
              + " is measured at "
              + from
              + " and at "
              + text(fix)
              + wheels
              + ": no fix until these agree; a robot that has driven must otherwise be lifted, or"
              + " start again",
          nowNs);
    } else {
      warn(
          printable(name)
              + " jumps from "
              + from
              + " to "
              + text(fix)
              + wheels
              + ": faster than a robot drives, or otherwise than its wheels, so no fix; further ones"
              + " are only counted: "
              + FeedDrop.JUMPED,
          nowNs);
    }
  }

  /** Names of robots are few, names that an attacker invents are many. */
  private static boolean isNewEpisode(Map<String, Long> episodes, String name, long nowNs) {
    boolean isFull = episodes.size() >= MOST_TOLD && !episodes.containsKey(name);
    Long lastNs = isFull ? Long.valueOf(nowNs) : episodes.put(name, nowNs);
    return lastNs == null || nowNs - lastNs > EPISODE_NS;
  }

  private static String text(Fix fix) {
    return PoseGate.text(fix.pose());
  }

  void warn(String what, long nowNs) {
    log.log(nowNs, LogSink.Level.WARN, tag, what);
  }

  void info(String what, long nowNs) {
    log.log(nowNs, LogSink.Level.INFO, tag, what);
  }

  /** Warns once for each {@code kind}, of which there are few. */
  void warnOnce(String kind, String what, long nowNs) {
    if (warned.add(kind)) {
      log.log(nowNs, LogSink.Level.WARN, tag, what);
    }
  }

  FeedStatistics statistics() {
    return new FeedStatistics(received, fixes, drops.counts());
  }
}
