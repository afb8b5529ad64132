package org.starl.primitives.paths;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.geometry.Point;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

/**
 * Claimants and voters without robots: messages are lost, duplicated and reordered at random,
 * writes are flushed late, and voters crash and restart with the flushed data.
 */
final class TubesWorld {

  private static final Instance SOURCE = Instance.of(TubeFact.PRIMITIVE, "world");
  private static final int RADIUS_MM = 240;
  private static final int MESH_MM = 500;
  private static final long STEP_NS = 20_000_000;

  /** Enough rounds for two messages with their answers, each with one repetition. */
  private static final int SETTLING = 4;

  /** The change of a planted bug. */
  record Bugs(int needed, boolean storesOnlyHeld, boolean votesBeforeFlush, boolean seesOnlyHeld) {
    static Bugs none(int robots) {
      return new Bugs(robots / 2 + 1, false, false, false);
    }
  }

  private final Rng rng;
  private final Bugs bugs;
  private final Participants participants;
  private final List<Node> nodes = new ArrayList<>();
  private final List<Runnable> air = new ArrayList<>();
  private final Monitors monitors = new Monitors(List.of(new TubesSpec(Long.MAX_VALUE)));
  private long nowNs;
  private int granted;

  TubesWorld(long seed, int robots, Bugs bugs) {
    this.rng = new Rng(seed);
    this.bugs = bugs;
    List<RobotId> ids = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      ids.add(new RobotId("bot" + i));
    }
    participants = Participants.of(ids);
    for (int i = 0; i < robots; i++) {
      nodes.add(new Node(ids.get(i), new Point(2 * MESH_MM * i, 0)));
    }
  }

  SpecReport run(int steps) {
    for (int i = 0; i < steps; i++) {
      nowNs += STEP_NS;
      Node node = nodes.get(rng.nextInt(nodes.size()));
      switch (rng.nextInt(12)) {
        case 0 -> node.act();
        case 1 -> node.claimant.timer(nowNs);
        case 2 -> node.maybeCrash();
        case 3, 4 -> node.flush();
        default -> deliver();
      }
    }
    return monitors.report();
  }

  /** The number of granted claims, without the first ones of discs. */
  int granted() {
    return granted;
  }

  /**
   * Repairs the network, so that every claim is decided. Then each robot in turn claims a tube that
   * meets no other tube.
   *
   * @return the number of granted claims; all, unless a robot is stuck for ever
   */
  int grantedOnceWhole() {
    settle();
    for (Node node : nodes) {
      node.standStill();
    }
    settle();
    int before = granted;
    for (Node node : nodes) {
      node.askToStay();
      settle();
    }
    return granted - before;
  }

  /** Lets time pass until all messages have arrived and all writes are flushed. */
  private void settle() {
    for (int i = 0; i < SETTLING; i++) {
      nowNs += TubeSettings.DEFAULT.maxResendNs();
      for (Node node : nodes) {
        node.claimant.timer(nowNs);
      }
      while (!air.isEmpty()) {
        air.remove(0).run();
        nodes.forEach(Node::flush);
      }
    }
  }

  private void deliver() {
    if (air.isEmpty()) {
      return;
    }
    int which = rng.nextInt(air.size());
    Runnable message = air.get(which);
    if (!rng.nextBoolean(0.1)) {
      air.remove(which);
    }
    if (!rng.nextBoolean(0.1)) {
      message.run();
    }
  }

  private final class Node implements TubeVoter.Out, TubeClaimant.Out {
    private final RobotId id;
    private final Point start;
    private final TubeClaimant claimant;
    private final SortedMap<RobotId, TubeVoter.Note> flushed = new TreeMap<>();
    private final Deque<Runnable> writes = new ArrayDeque<>();
    private TubeVoter voter;

    Node(RobotId id, Point start) {
      this.id = id;
      this.start = start;
      claimant =
          new TubeClaimant(participants, bugs.needed(), TubeSettings.DEFAULT, Holding.NONE, this);
      voter = newVoter();
    }

    private TubeVoter newVoter() {
      return bugs.seesOnlyHeld()
          ? new TubeVoter(participants, this) {
            @Override
            List<Tube> tubesOf(RobotId robot) {
              List<Tube> all = super.tubesOf(robot);
              return all.size() > 1 ? all.subList(0, 1) : all;
            }
          }
          : new TubeVoter(participants, this);
    }

    void act() {
      List<Tube> held = claimant.holding().held();
      if (claimant.isAsking()) {
        if (rng.nextBoolean(0.1)) {
          claimant.withdraw(nowNs);
        }
      } else if (held.isEmpty()) {
        claimant.ask(Tube.disc(start, RADIUS_MM), nowNs);
      } else if (held.size() > 1) {
        claimant.keep(List.of(held.get(1)), nowNs);
      } else if (held.get(0).points().size() > 1) {
        claimant.keep(List.of(held.get(0).from(1)), nowNs);
      } else {
        claimant.ask(wayFrom(held.get(0).end()), nowNs);
      }
      show();
    }

    /** Keeps one tube: the latest, or the disc at the robot's place. */
    void standStill() {
      List<Tube> held = claimant.holding().held();
      if (held.isEmpty()) {
        claimant.ask(Tube.disc(start, RADIUS_MM), nowNs);
      } else if (held.size() > 1) {
        claimant.keep(List.of(held.get(1)), nowNs);
      }
      show();
    }

    /** Requests a tube at its own place, which no other robot can hold. */
    void askToStay() {
      List<Tube> held = claimant.holding().held();
      if (!held.isEmpty()) {
        Point end = held.get(0).end();
        claimant.ask(new Tube(List.of(end, end), RADIUS_MM), nowNs);
      }
    }

    private Tube wayFrom(Point from) {
      List<Point> points = new ArrayList<>(List.of(from));
      for (int i = 0; i <= rng.nextInt(2); i++) {
        points.add(
            new Point(
                (double) MESH_MM * rng.nextInt(2 * nodes.size()),
                (double) MESH_MM * rng.nextInt(4)));
      }
      return new Tube(points, RADIUS_MM);
    }

    void maybeCrash() {
      if (rng.nextBoolean(0.3)) {
        writes.clear();
        voter = newVoter();
        flushed.forEach(this::restore);
      }
    }

    private void restore(RobotId about, TubeVoter.Note note) {
      voter.restore(
          about,
          bugs.storesOnlyHeld() ? new TubeVoter.Note(note.holding().withoutWanted(), false) : note);
    }

    void flush() {
      if (!writes.isEmpty()) {
        writes.remove().run();
      }
    }

    @Override
    public void send(RobotId to, TubeMessage message) {
      for (Node node : nodes) {
        if (node.id.equals(to)) {
          air.add(() -> node.receive(id, message));
        }
      }
    }

    private void receive(RobotId from, TubeMessage message) {
      switch (message) {
        case TubeMessage.Ask m -> voter.asked(from, m.holding());
        case TubeMessage.Vote m -> claimant.voted(from, m.version(), nowNs);
        case TubeMessage.Refuse m -> claimant.refused(from, m.version(), nowNs);
      }
      show();
    }

    @Override
    public void persist(RobotId about, TubeVoter.Note note, TubeMessage answer) {
      if (bugs.votesBeforeFlush()) {
        send(about, answer);
      }
      writes.add(() -> {
        flushed.put(about, note);
        send(about, answer);
      });
    }

    @Override
    public void granted(Tube tube) {
      if (tube.points().size() > 1) {
        granted++;
      }
    }

    @Override
    public void refused() {
      // It will request another tube.
    }

    private void show() {
      monitors.observe(
          new Variable(nowNs, id, SOURCE, TubeFact.HELD, new TubeList(claimant.holding().held())));
    }
  }
}
