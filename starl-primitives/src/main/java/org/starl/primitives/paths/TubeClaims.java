package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Timer;

/**
 * What a robot holds, and its vote: {@link TubeClaimant} and {@link TubeVoter} on its gvh. With the
 * first fix it claims the disc where it stands. Strand only.
 */
final class TubeClaims {

  private final GlobalVarHolder gvh;
  private final TubeSettings settings;
  private final int radiusMm;
  private final Listener listener;
  private final TubeStore store;
  private final TubeVoter voter;
  private final TubeClaimant claimant;
  private final Endpoint<TubeMessage> endpoint;
  private final GvhCell<Holdings> held;
  private final Timer timer;

  /** What refusals have told of others; they may know more than this robot's own notes. */
  private final SortedMap<RobotId, Holding> heard = new TreeMap<>();

  /** Where this robot asks to stand, until that is granted. */
  private @Nullable Tube standing;

  private long placeAgainNs;
  private int writes;
  private boolean closed;

  /** Takes what becomes of claims; each in a piece of its own. */
  interface Listener {

    /** The claim is granted, and would survive a restart. */
    void granted(Tube tube);

    void refused();

    /** The others know where this robot stands, and nothing of what it holds is being written. */
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
    store = new TubeStore(gvh.plat.stable, channel.name());
    voter = new TubeVoter(participants, new VoterWiring());
    for (RobotId robot : participants) {
      TubeVoter.Note note = store.note(robot);
      if (note != null) {
        voter.restore(robot, note);
      }
    }
    Holding before = store.own();
    Holding start = before == null ? Holding.NONE : before;
    standing = start.wanted().isEmpty() ? null : start.wanted().get(0);
    claimant =
        new TubeClaimant(
            participants,
            participants.size() / 2 + 1,
            settings,
            start.inBoot(gvh.id.boot()),
            new ClaimantWiring());
    held = gvh.variable(channel.name(), TubeTrace.HELD, new Holdings(start.held()));
    timer = gvh.plat.timers.timer(this::expired);
    endpoint = gvh.comms.open(channel, this::received);
    gvh.gps.onFix(this::place);
    if (!start.held().isEmpty()) {
      claimant.keep(start.held(), nowNs());
      rearm();
    }
  }

  boolean isPlaced() {
    return !claimant.holding().held().isEmpty();
  }

  /** Whether a new claim may begin: the robot is placed, and nothing is being written. */
  boolean isSettled() {
    return isPlaced() && writes == 0 && !claimant.isAsking();
  }

  List<Tube> held() {
    return held.get().tubes();
  }

  List<RobotId> unplaced() {
    return voter.unplaced();
  }

  /** All parts of all that others hold or want, as far as this robot has heard. */
  List<Capsule> taken() {
    SortedMap<RobotId, Holding> latest = voter.others(gvh.id.name());
    for (Map.Entry<RobotId, Holding> entry : heard.entrySet()) {
      Holding noted = latest.get(entry.getKey());
      if (noted == null || noted.version() < entry.getValue().version()) {
        latest.put(entry.getKey(), entry.getValue());
      }
    }
    List<Capsule> taken = new ArrayList<>();
    for (Holding holding : latest.values()) {
      for (Tube tube : holding.all()) {
        for (int i = 0; i < tube.parts(); i++) {
          taken.add(tube.part(i));
        }
      }
    }
    return taken;
  }

  void ask(Tube tube) {
    claimant.ask(tube, nowNs());
    rearm();
  }

  /** Wants no tube any more; where it stands it asks for all the same, until it has it. */
  void withdraw() {
    if (standing == null) {
      claimant.withdraw(nowNs());
      rearm();
    }
  }

  /**
   * Gives back all but {@code rest}. It is written before it is said: a robot that restarted must not
   * believe that it holds what others have by then.
   */
  void keep(List<Tube> rest) {
    write(
        new Holding(0, rest, List.of()),
        () -> {
          claimant.keep(rest, nowNs());
          held.set(new Holdings(rest));
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
    // Written before it is said: a restarted robot asks for the same place.
    Tube disc = standing;
    placeAgainNs = Long.MAX_VALUE;
    write(new Holding(0, List.of(), List.of(disc)), () -> ask(disc));
  }

  private void write(Holding own, Runnable then) {
    writes++;
    store.putOwn(
        own,
        () -> {
          if (!closed) {
            writes--;
            then.run();
            tellIfSettled();
          }
        });
  }

  private void tellIfSettled() {
    if (isSettled()) {
      listener.settled();
    }
  }

  private void received(RobotId from, TubeMessage message) {
    switch (message) {
      case TubeMessage.Ask m -> voter.asked(from, m.holding());
      case TubeMessage.Vote m -> claimant.voted(from, m.version(), nowNs());
      case TubeMessage.Refuse m -> {
        if (m.theirs().version() > 0) {
          heard.merge(m.who(), m.theirs(), TubeClaims::newer);
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
    long atNs = claimant.wakeAtNs();
    if (closed || atNs == Long.MAX_VALUE) {
      timer.cancel();
    } else {
      timer.set(atNs);
    }
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
      store.putNote(
          about,
          note,
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
      held.set(new Holdings(now.held()));
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
        // Two robots were put down too near to each other; somebody may take the other one away.
        placeAgainNs = nowNs() + settings.maxResendNs();
      } else {
        listener.refused();
      }
    }
  }
}
