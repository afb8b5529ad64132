package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.Persistent;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.shape.Shapes;

/**
 * Connects the {@link TubeClaimant} and the {@link TubeVoter} of a robot to its gvh. At the first
 * fix it claims the disc at the robot's place. Strand only.
 */
final class TubeClaims {

  private final GlobalVarHolder gvh;
  private final TubeSettings settings;
  private final int radiusMm;
  private final Listener listener;
  private final Persistent<Optional<TubeVoter.Note>> own;
  private final Map<RobotId, Persistent<Optional<TubeVoter.Note>>> notes = new TreeMap<>();
  private final TubeVoter voter;
  private final TubeClaimant claimant;
  private final Endpoint<TubeMessage> endpoint;
  private final GvhCell<TubeList> held;
  private final Timer timer;

  /** The tubes of others as reported in refusals; they may be newer than this robot's notes. */
  private final SortedMap<RobotId, Holding> reported = new TreeMap<>();

  /** The disc at this robot's place, until it is granted. */
  private @Nullable Tube standing;

  /** Robots whose tubes met the tube of the latest request, as told by refusals. */
  private final SortedSet<RobotId> inTheWay = new TreeSet<>();

  private long placeAgainNs;
  private int writes;
  private boolean closed;

  /** Receives the outcomes of claims; each call is in a separate step of the strand. */
  interface Listener {

    /** The claim is granted and stored, so that it survives a restart. */
    void granted(Tube tube);

    void refused();

    /** The others know this robot's place, and no write to stable storage is pending. */
    void settled();
  }

  TubeClaims(
      GlobalVarHolder gvh,
      Channel<TubeMessage> channel,
      Participants participants,
      TubeSettings settings,
      int radiusMm,
      Listener listener) {
    this.gvh = gvh;
    this.settings = settings;
    this.radiusMm = radiusMm;
    this.listener = listener;
    own = stored(channel.name() + ".own");
    voter = new TubeVoter(participants, new VoterWiring());
    for (RobotId robot : participants) {
      Persistent<Optional<TubeVoter.Note>> note = stored(channel.name() + ".note." + robot);
      notes.put(robot, note);
      note.get().ifPresent(known -> voter.restore(robot, known));
    }
    // The held tubes and, before the first grant, the disc at the robot's place.
    Holding start = own.get().map(TubeVoter.Note::holding).orElse(Holding.NONE);
    standing = start.wanted().isEmpty() ? null : start.wanted().get(0);
    claimant =
        new TubeClaimant(
            participants,
            participants.size() / 2 + 1,
            settings,
            start.inBoot(gvh.id.boot()),
            new ClaimantWiring());
    held = gvh.variable(channel.instance(), TubeFact.HELD, new TubeList(start.held()));
    timer = gvh.plat.timers.timer(this::expired);
    endpoint = gvh.comms.open(channel, this::received);
    gvh.gps.onFix(this::place);
    if (!start.held().isEmpty()) {
      claimant.keep(start.held(), nowNs());
      rearm();
    }
  }

  private Persistent<Optional<TubeVoter.Note>> stored(String name) {
    return gvh.plat.persistent(name, Shapes.optional(TubeVoter.Note.SHAPE), Optional.empty());
  }

  boolean isPlaced() {
    return !claimant.holding().held().isEmpty();
  }

  /** Whether a new claim may begin: the robot is placed, and no write or request is pending. */
  boolean isSettled() {
    return isPlaced() && writes == 0 && !claimant.isAsking();
  }

  List<Tube> held() {
    return held.get().tubes();
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
    SortedMap<RobotId, Holding> latest = voter.others(gvh.id.name());
    reported.forEach((robot, holding) -> latest.merge(robot, holding, TubeClaims::newer));
    return latest;
  }

  void ask(Tube tube) {
    inTheWay.clear();
    claimant.ask(tube, nowNs());
    rearm();
  }

  /** Cancels a request for a tube, but not the first one, for the disc at the robot's place. */
  void withdraw() {
    if (standing == null) {
      claimant.withdraw(nowNs());
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
          claimant.keep(rest, nowNs());
          held.set(new TubeList(rest));
          rearm();
        });
  }

  void close() {
    closed = true;
    timer.cancel();
    endpoint.close();
  }

  private void place() {
    if (closed || isPlaced() || claimant.isAsking() || nowNs() < placeAgainNs) {
      return;
    }
    if (standing == null) {
      standing = Tube.disc(gvh.gps.pose().at(), radiusMm);
    }
    // Stored before it is sent, so that a restarted robot asks for the same place.
    Tube disc = standing;
    placeAgainNs = Long.MAX_VALUE;
    write(new Holding(0, List.of(), List.of(disc)), () -> ask(disc));
  }

  private void write(Holding holding, Runnable then) {
    writes++;
    own.set(
        Optional.of(new TubeVoter.Note(holding, false)),
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

  private void received(RobotId from, TubeMessage message) {
    switch (message) {
      case TubeMessage.Ask m -> voter.asked(from, m.holding());
      case TubeMessage.Vote m -> claimant.voted(from, m.version(), nowNs());
      case TubeMessage.Refuse m -> {
        if (m.theirs().version() > 0) {
          reported.merge(m.who(), m.theirs(), TubeClaims::newer);
        }
        if (m.version() == claimant.holding().version()) {
          inTheWay.add(m.who());
        }
        claimant.refused(from, m.version(), nowNs());
      }
    }
    rearm();
  }

  private static Holding newer(Holding a, Holding b) {
    return a.version() >= b.version() ? a : b;
  }

  private void expired() {
    claimant.timer(nowNs());
    rearm();
  }

  private void rearm() {
    timer.set(closed ? Timer.NEVER : claimant.wakeAtNs());
  }

  private long nowNs() {
    return gvh.plat.clock.nowNs();
  }

  private final class VoterWiring implements TubeVoter.Out {
    @Override
    public void send(RobotId to, TubeMessage message) {
      endpoint.send(to, message);
    }

    @Override
    public void persist(RobotId about, TubeVoter.Note note, TubeMessage answer) {
      Objects.requireNonNull(notes.get(about))
          .set(
              Optional.of(note),
              () -> {
                if (!closed) {
                  endpoint.send(about, answer);
                }
              });
    }
  }

  private final class ClaimantWiring implements TubeClaimant.Out {
    @Override
    public void send(RobotId to, TubeMessage message) {
      endpoint.send(to, message);
    }

    @Override
    public void granted(Tube tube) {
      Holding now = claimant.holding();
      held.set(new TubeList(now.held()));
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
        placeAgainNs = nowNs() + settings.maxResendNs();
      } else {
        listener.refused();
      }
    }
  }
}
