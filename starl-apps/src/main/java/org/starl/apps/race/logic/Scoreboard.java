package org.starl.apps.race.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.primitives.geocast.Broadcast;
import org.starl.primitives.geocast.GeocastReceipt;
import org.starl.primitives.geocast.GeocastSettings;
import org.starl.random.Rng;

/**
 * Who has won which point, as far as one robot knows. What it learns it announces by Broadcast, the
 * winner's own claim as well as others', again and again until every robot of the deployment has
 * acknowledged: so a winner that crashes as soon as one robot has heard of it is not forgotten, and
 * whoever was cut off learns when it is not any more. It goes on when the app has ended, as long as
 * the robot is up. After the first time it leaves that to others as long as it hears them do it, as
 * Trickle does (Levis et al., RFC 6206): robots that are dead are called by one at a time. Strand
 * only.
 */
public final class Scoreboard {

  /** Action with a point's place and name, the winner, its time and how far it was kept off. */
  public static final String TAKEN = "taken";

  private static final long NS_PER_MS = 1_000_000;
  private static final long ANNOUNCE_MS = 5_000;
  private static final long ROUND_MS = 500;
  private static final long LEAST_QUIET_MS = 6_000;
  private static final long MOST_QUIET_MS = 8_000;

  /** Clocks that are up to 200 ppm off differ by no more after four minutes. */
  public static final long CLOCK_SKEW_NS = 100_000_000;

  static final GeocastSettings SETTINGS =
      new GeocastSettings(
          GeocastSettings.DEFAULT.resendMs(),
          GeocastSettings.DEFAULT.maxResendMs(),
          CLOCK_SKEW_NS,
          false);

  private final GlobalVarHolder gvh;
  private final String source;
  private final List<RacePoint> points;
  private final List<Entry> entries = new ArrayList<>();
  private final Broadcast<RaceMessage> broadcast;
  private final Timer rounds;
  private final Rng rng;

  /** What is known of one point. */
  private static final class Entry {
    private @Nullable Claim best;
    // Who knows the best claim, or a better one, for certain.
    private final Set<RobotId> informed = new TreeSet<>();
    private @Nullable GeocastReceipt cast;
    // Others call out the best claim: this robot need not until then.
    private long quietUntilNs;

    void learnAcknowledgements() {
      if (cast != null) {
        informed.addAll(cast.acknowledgedBy());
      }
    }

    /** Whoever has acknowledged it before does not know it now, and has to be told again. */
    void forgottenBy(RobotId robot) {
      learnAcknowledgements();
      if (informed.remove(robot)) {
        cast = null;
      }
    }
  }

  /**
   * @param xid the race: robots with another one are in another race
   * @param source of its trace events
   */
  public Scoreboard(GlobalVarHolder gvh, String xid, List<RacePoint> points, String source) {
    this.gvh = gvh;
    this.source = source;
    this.points = List.copyOf(points);
    points.forEach(point -> entries.add(new Entry()));
    broadcast = new Broadcast<>(gvh, xid, new RaceCodec(points.size()), this::heard, SETTINGS);
    rng = gvh.plat.entropy.fork("scoreboard");
    rounds = gvh.plat.timers.timer(this::round);
    if (gvh.id.boot() > 1) {
      broadcast.BCast(new RaceMessage.Question(), ANNOUNCE_MS);
    }
  }

  /** What the arguments of {@link #TAKEN} say. */
  public static Claim claim(List<String> args) {
    return new Claim(
        Integer.parseInt(args.get(0)),
        new RobotId(args.get(2)),
        Long.parseLong(args.get(3)),
        Integer.parseInt(args.get(4)));
  }

  /** The first point that nobody is known to have won; as many as there are points if all are won. */
  public int next() {
    int next = 0;
    while (next < entries.size() && isTaken(next)) {
      next++;
    }
    return next;
  }

  public boolean isTaken(int point) {
    return entries.get(point).best != null;
  }

  /** The best claim on each point that is known, in the points' order. */
  public List<Claim> claims() {
    List<Claim> claims = new ArrayList<>();
    entries.forEach(entry -> Optional.ofNullable(entry.best).ifPresent(claims::add));
    return claims;
  }

  /**
   * This robot has won {@code point}, as far as it knows.
   *
   * @param keptOffMm 0 if it is there
   */
  public void claim(int point, int keptOffMm) {
    learn(new Claim(point, gvh.id.name(), gvh.plat.clock.nowNs(), keptOffMm));
  }

  /** Whether every other robot has acknowledged every winner that this one knows. */
  public boolean isConfirmed() {
    return unconfirmed().isEmpty();
  }

  /** The robots of which it is not certain that they know every winner that this one knows. */
  public Set<RobotId> unconfirmed() {
    Set<RobotId> missing = new TreeSet<>();
    for (Entry entry : entries) {
      if (entry.best != null) {
        missing.addAll(missingOf(entry));
      }
    }
    return missing;
  }

  private Set<RobotId> missingOf(Entry entry) {
    entry.learnAcknowledgements();
    Set<RobotId> missing = new TreeSet<>(gvh.id.participants().asList());
    missing.removeAll(entry.informed);
    missing.remove(gvh.id.name());
    return missing;
  }

  private void heard(RobotId from, RaceMessage message) {
    switch (message) {
      case Claim claim -> heard(from, claim);
      case RaceMessage.Question question -> {
        for (Entry entry : entries) {
          entry.forgottenBy(from);
          announce(entry);
        }
      }
    }
  }

  private void heard(RobotId from, Claim claim) {
    learn(claim);
    Entry entry = entries.get(claim.point());
    if (claim.equals(entry.best)) {
      entry.informed.add(from);
      keepQuiet(entry);
    } else {
      // Who claims what another has won already has to be told; it may have started anew.
      entry.forgottenBy(from);
      announce(entry);
    }
  }

  private void learn(Claim claim) {
    Entry entry = entries.get(claim.point());
    if (entry.best != null && entry.best.compareTo(claim) <= 0) {
      return;
    }
    entry.best = claim;
    entry.cast = null;
    entry.informed.clear();
    gvh.trace.action(
        source,
        TAKEN,
        claim.point(),
        points.get(claim.point()).name(),
        claim.winner(),
        claim.atNs(),
        claim.keptOffMm());
    announce(entry);
  }

  /** Unless an announcement is under way already. */
  private void announce(Entry entry) {
    Claim best = entry.best;
    if (best != null && (entry.cast == null || entry.cast.isComplete())) {
      entry.cast = broadcast.BCast(best, ANNOUNCE_MS);
      keepQuiet(entry);
      rounds.set(gvh.plat.clock.nowNs() + ROUND_MS * NS_PER_MS);
    }
  }

  private void keepQuiet(Entry entry) {
    long quietMs = rng.nextLong(LEAST_QUIET_MS, MOST_QUIET_MS);
    entry.quietUntilNs = gvh.plat.clock.nowNs() + quietMs * NS_PER_MS;
  }

  private void round() {
    boolean isOver = true;
    for (Entry entry : entries) {
      if (entry.best != null && !missingOf(entry).isEmpty()) {
        isOver = false;
        if (gvh.plat.clock.nowNs() >= entry.quietUntilNs) {
          announce(entry);
        }
      }
    }
    if (!isOver) {
      rounds.set(gvh.plat.clock.nowNs() + ROUND_MS * NS_PER_MS);
    }
  }
}
