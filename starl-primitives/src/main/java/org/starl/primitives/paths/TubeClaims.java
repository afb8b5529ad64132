package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Timer;

/**
 * The {@link TubeClaimant} and the {@link TubeVoter} of a robot, and what they keep on stable storage.
 * At the first fix it claims the disc at the robot's place. Strand only.
 */
final class TubeClaims {

  static final String OWN = ".own";

  private final TubeSettings settings;
  private final int radiusMm;
  private final Port port;
  private final Listener listener;
  private final RobotId me;
  private final TubeVoter voter;
  private final TubeClaimant claimant;
  private TubeList held;

  /** The tubes of others as reported in refusals; they may be newer than this robot's notes. */
  private final SortedMap<RobotId, Holding> reported = new TreeMap<>();

  /** The disc at this robot's place, until it is granted. */
  private @Nullable Tube standing;

  /** Robots whose tubes met the tube of the latest request, as told by refusals. */
  private final SortedSet<RobotId> inTheWay = new TreeSet<>();

  private long placeAgainNs;
  private int writes;
  private boolean closed;

  /** What the claims need of their robot. */
  interface Port {

    long nowNs();

    /** The robot's position. */
    Point at();

    /** What was stored by {@code name} before this start. */
    Optional<TubeVoter.Note> stored(String name);

    /** Stores, and calls {@code whenFlushed} once a crash does not lose it; never inside this call. */
    void store(String name, TubeVoter.Note note, Runnable whenFlushed);

    /** Sends, best effort, also to this robot itself. */
    void send(RobotId to, TubeMessage message);

    /** The tubes that the robot holds now. */
    void holds(TubeList tubes);

    /** {@link #expired} is due at this time; replaces the time before. */
    void wakeAt(long timeNs);
  }

  /** Receives the outcomes of claims; each call is in a separate step of the strand. */
  interface Listener {

    /** The claim is granted and stored, so that it survives a restart. */
    void granted(Tube tube);

    void refused();

    /** The others know this robot's place, and no write to stable storage is pending. */
    void settled();
  }

  TubeClaims(
      RobotId me,
      int boot,
      Participants participants,
      TubeSettings settings,
      int radiusMm,
      Port port,
      Listener listener) {
    this.me = me;
    this.settings = settings;
    this.radiusMm = radiusMm;
    this.port = port;
    this.listener = listener;
    Optional<TubeVoter.Note> own = port.stored(OWN);
    voter = new TubeVoter(participants, new VoterWiring());
    for (RobotId robot : participants) {
      port.stored(note(robot)).ifPresent(known -> voter.restore(robot, known));
    }
    // The held tubes and, before the first grant, the disc at the robot's place.
    Holding start = own.map(TubeVoter.Note::holding).orElse(Holding.NONE);
    standing = start.wanted().isEmpty() ? null : start.wanted().get(0);
    claimant =
        new TubeClaimant(
            participants,
            participants.size() / 2 + 1,
            settings,
            start.inBoot(boot),
            new ClaimantWiring());
    held = new TubeList(start.held());
  }

  static String note(RobotId robot) {
    return ".note." + robot;
  }

  /** Tells the others of the tubes that it holds since before a restart. */
  void begin() {
    if (!held().isEmpty()) {
      claimant.keep(held(), port.nowNs());
      rearm();
    }
  }

  boolean isPlaced() {
    return !claimant.holding().held().isEmpty();
  }

  /** Whether a new claim may begin: the robot is placed, and no write or request is pending. */
  boolean isSettled() {
    return isPlaced() && writes == 0 && !claimant.isAsking();
  }

  boolean isAsking() {
    return claimant.isAsking();
  }

  List<Tube> held() {
    return held.tubes();
  }

  /** Robots whose tubes met the tube of the latest request, as far as known. */
  List<RobotId> inTheWay() {
    return List.copyOf(inTheWay);
  }

  /** Robots whose tubes meet {@code tube}, as far as this robot knows. */
  List<RobotId> meeting(Tube tube) {
    List<RobotId> robots = new ArrayList<>();
    latest()
        .forEach((robot, holding) -> {
          if (Tube.meet(List.of(tube), holding.all())) {
            robots.add(robot);
          }
        });
    return robots;
  }

  List<RobotId> unplaced() {
    return voter.unplaced();
  }

  /** All parts of tubes that others hold or want, as far as this robot knows. */
  List<Capsule> taken() {
    return latest().values().stream()
        .flatMap(holding -> holding.all().stream())
        .flatMap(tube -> tube.capsules().stream())
        .collect(Collectors.toList());
  }

  private SortedMap<RobotId, Holding> latest() {
    SortedMap<RobotId, Holding> latest = voter.others(me);
    reported.forEach((robot, holding) -> latest.merge(robot, holding, TubeClaims::newer));
    return latest;
  }

  void ask(Tube tube) {
    inTheWay.clear();
    claimant.ask(tube, port.nowNs());
    rearm();
  }

  /** Cancels a request for a tube, but not the first one, for the disc at the robot's place. */
  void withdraw() {
    if (standing == null) {
      claimant.withdraw(port.nowNs());
      rearm();
    }
  }

  /**
   * Releases all but {@code rest}. The change is stored before it is sent: after a restart, a robot
   * must not believe that it holds tubes that others hold by then.
   */
  void keep(List<Tube> rest) {
    write(
        new Holding(0, rest, List.of()),
        () -> {
          claimant.keep(rest, port.nowNs());
          show(rest);
          rearm();
        });
  }

  private void show(List<Tube> tubes) {
    held = new TubeList(tubes);
    port.holds(held);
  }

  void close() {
    closed = true;
    rearm();
  }

  /** Its robot has a position. */
  void place() {
    if (closed || isPlaced() || claimant.isAsking() || port.nowNs() < placeAgainNs) {
      return;
    }
    if (standing == null) {
      standing = Tube.disc(port.at(), radiusMm);
    }
    // Stored before it is sent, so that a restarted robot asks for the same place.
    Tube disc = standing;
    placeAgainNs = Long.MAX_VALUE;
    write(new Holding(0, List.of(), List.of(disc)), () -> ask(disc));
  }

  private void write(Holding holding, Runnable then) {
    writes++;
    port.store(
        OWN,
        new TubeVoter.Note(holding, false),
        () -> {
          if (!closed) {
            writes--;
            then.run();
            if (isSettled()) {
              listener.settled();
            }
          }
        });
  }

  void received(RobotId from, TubeMessage message) {
    switch (message) {
      case TubeMessage.Ask m -> voter.asked(from, m.holding());
      case TubeMessage.Vote m -> claimant.voted(from, m.version(), port.nowNs());
      case TubeMessage.Refuse m -> {
        if (m.theirs().version() > 0) {
          reported.merge(m.who(), m.theirs(), TubeClaims::newer);
        }
        if (m.version() == claimant.holding().version()) {
          inTheWay.add(m.who());
        }
        claimant.refused(from, m.version(), port.nowNs());
      }
    }
    rearm();
  }

  /** All that decides which tubes it holds, wants and consents to from now on. */
  String state() {
    return claimant.state() + voter.state() + standing + placeAgainNs + writes;
  }

  /** Whether a message has no effect, now and until a restart. */
  boolean isSpent(RobotId from, TubeMessage message) {
    return message instanceof TubeMessage.Ask
        ? message.version() < voter.version(from)
        : claimant.isSpent(from, message.version());
  }

  private static Holding newer(Holding a, Holding b) {
    return a.version() >= b.version() ? a : b;
  }

  /** The time of {@link Port#wakeAt}. */
  void expired() {
    claimant.timer(port.nowNs());
    rearm();
  }

  private void rearm() {
    port.wakeAt(closed ? Timer.NEVER : claimant.wakeAtNs());
  }

  private final class VoterWiring implements TubeVoter.Out {
    @Override
    public void send(RobotId to, TubeMessage message) {
      port.send(to, message);
    }

    @Override
    public void persist(RobotId about, TubeVoter.Note note, TubeMessage answer) {
      port.store(
          note(about),
          note,
          () -> {
            if (!closed) {
              port.send(about, answer);
            }
          });
    }
  }

  private final class ClaimantWiring implements TubeClaimant.Out {
    @Override
    public void send(RobotId to, TubeMessage message) {
      port.send(to, message);
    }

    @Override
    public void granted(Tube tube) {
      Holding now = claimant.holding();
      show(now.held());
      boolean first = tube.equals(standing);
      standing = null;
      write(
          now,
          () -> {
            if (!first) {
              listener.granted(tube);
            }
          });
    }

    @Override
    public void refused() {
      if (standing != null) {
        // Two robots stand too close together; a person may move one of them.
        placeAgainNs = port.nowNs() + settings.maxResendNs();
      } else {
        listener.refused();
      }
    }
  }
}
