package org.starl.apps.race.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.apps.race.logic.RaceFact.Taken;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.id.RobotSet;
import org.starl.platform.Timer;
import org.starl.primitives.geocast.Broadcast;
import org.starl.primitives.geocast.GeocastReceipt;
import org.starl.primitives.geocast.GeocastSettings;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * The winners of the points, as far as one robot knows them. It broadcasts every claim that it
 * learns, its own and others', again and again until all robots of the deployment have acknowledged
 * it. So a claim survives its winner's crash once another robot has heard it, and a robot that was
 * cut off learns it later. It goes on after the app has ended, as long as the robot is up. After
 * its first announcement a robot stays quiet while it hears others announce the same claim, as in
 * Trickle (Levis et al., RFC 6206): only one robot at a time calls robots that are dead. Strand
 * only.
 */
public final class Scoreboard {

  private static final long ANNOUNCE_MS = 5_000;
  private static final long ROUND_MS = 500;
  private static final long MIN_QUIET_MS = 6_000;
  private static final long MAX_QUIET_MS = 8_000;

  /** Clocks that are up to 200 ppm off differ by no more after four minutes. */
  private static final long CLOCK_SKEW_NS = 100 * Time.NS_PER_MS;

  public static final GeocastSettings SETTINGS =
      GeocastSettings.DEFAULT.withClockSkewNs(CLOCK_SKEW_NS);

  private final GlobalVarHolder gvh;
  private final List<RacePoint> points;
  private final List<Entry> entries = new ArrayList<>();
  private final Broadcast<RaceMessage> broadcast;
  private final Timer rounds;
  private final Rng rng;

  /** What is known of one point. */
  private static final class Entry {
    private @Nullable Claim best;

    /** The robots that certainly know the best claim, or a better one. */
    private final RobotSet informed;

    private @Nullable GeocastReceipt cast;

    /** Until then this robot leaves the announcement of the best claim to others. */
    private long quietUntilNs;

    Entry(Participants deployment) {
      informed = new RobotSet(deployment);
    }

    void learnAcknowledgements() {
      if (cast != null) {
        cast.addAcknowledgedBy(informed);
      }
    }

    /** A robot does not know the claim any more, so a new announcement has to reach it. */
    void forgottenBy(RobotId robot) {
      learnAcknowledgements();
      if (informed.remove(robot)) {
        cast = null;
      }
    }
  }

  /**
   * @param xid the name of the race: robots with another one are in another race
   */
  Scoreboard(GlobalVarHolder gvh, String xid, List<RacePoint> points) {
    this.gvh = gvh;
    this.points = List.copyOf(points);
    points.forEach(point -> entries.add(new Entry(gvh.id.participants())));
    broadcast = new Broadcast<>(gvh, xid, RaceMessage.shape(points.size()), this::heard, SETTINGS);
    rng = gvh.plat.entropy.fork("scoreboard");
    rounds = gvh.plat.timers.timer(this::round);
    if (gvh.id.boot() > 1) {
      broadcast.BCast(new RaceMessage.Question(), ANNOUNCE_MS);
    }
  }

  /** The first point without a known winner; the number of points if all have one. */
  int next() {
    int next = 0;
    while (next < entries.size() && isTaken(next)) {
      next++;
    }
    return next;
  }

  boolean isTaken(int point) {
    return entries.get(point).best != null;
  }

  /** The winners of the points that have one, in the points' order. */
  List<RobotId> winners() {
    List<RobotId> winners = new ArrayList<>();
    for (Entry entry : entries) {
      if (entry.best != null) {
        winners.add(entry.best.winner());
      }
    }
    return winners;
  }

  /**
   * This robot has won {@code point}, as far as it knows.
   *
   * @param keptOffMm 0 if it is at the point
   */
  void claim(int point, int keptOffMm) {
    learn(new Claim(point, gvh.id.name(), gvh.plat.clock.nowNs(), keptOffMm));
  }

  /** The robots that have not acknowledged every winner that this one knows. */
  Set<RobotId> unconfirmed() {
    Set<RobotId> missing = new TreeSet<>();
    entries.forEach(entry -> missing.addAll(missingOf(entry)));
    return missing;
  }

  private Set<RobotId> missingOf(Entry entry) {
    if (entry.best == null) {
      return Set.of();
    }
    entry.learnAcknowledgements();
    Set<RobotId> missing = entry.informed.missing();
    missing.remove(gvh.id.name());
    return missing;
  }

  private void heard(RobotId from, RaceMessage message) {
    if (message instanceof Claim claim) {
      learn(claim);
      Entry entry = entries.get(claim.point());
      if (claim.equals(entry.best)) {
        entry.informed.add(from);
        keepQuiet(entry);
      } else {
        inform(from, entry); // it knows no better claim: it may have restarted
      }
    } else {
      entries.forEach(entry -> inform(from, entry)); // it has restarted
    }
  }

  private void inform(RobotId robot, Entry entry) {
    entry.forgottenBy(robot);
    announce(entry);
  }

  private void learn(Claim claim) {
    Entry entry = entries.get(claim.point());
    if (entry.best == null || claim.compareTo(entry.best) < 0) {
      entry.best = claim;
      entry.cast = null;
      entry.informed.clear();
      gvh.trace.action(Taken.SHAPE, Taken.of(claim, points.get(claim.point())));
      announce(entry);
    }
  }

  /** Announces the best claim, unless an announcement is under way. */
  private void announce(Entry entry) {
    Claim best = entry.best;
    if (best != null && (entry.cast == null || entry.cast.isComplete())) {
      entry.cast = broadcast.BCast(best, ANNOUNCE_MS);
      keepQuiet(entry);
      setNextRound();
    }
  }

  private void keepQuiet(Entry entry) {
    long quietMs = rng.nextLong(MIN_QUIET_MS, MAX_QUIET_MS);
    entry.quietUntilNs = gvh.plat.clock.nowNs() + quietMs * Time.NS_PER_MS;
  }

  private void setNextRound() {
    rounds.set(gvh.plat.clock.nowNs() + ROUND_MS * Time.NS_PER_MS);
  }

  private void round() {
    for (Entry entry : entries) {
      if (!missingOf(entry).isEmpty()) {
        setNextRound();
        if (gvh.plat.clock.nowNs() >= entry.quietUntilNs) {
          announce(entry);
        }
      }
    }
  }
}
