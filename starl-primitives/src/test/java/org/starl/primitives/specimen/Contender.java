package org.starl.primitives.specimen;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.View;
import org.starl.random.Rng;

/** A robot that asks for sections again and again; how access is agreed upon is the specimen. */
abstract class Contender extends LogicThread {

  static final String XID = "specimen";

  private static final String SOURCE = "mutex/" + XID;
  private static final int ROUNDS = 12;
  private static final long TICK_MS = 50;

  final RobotId me;
  final List<RobotId> all;
  final List<RobotId> others;
  private final Rng rng;
  private final ProcessId id;

  Contender(GlobalVarHolder gvh) {
    super(gvh);
    me = gvh.id.name();
    all = gvh.id.participants().asList();
    others = new ArrayList<>(all);
    others.remove(me);
    rng = gvh.plat.entropy.fork("specimen");
    id = id(me);
  }

  /** What is asked for in the next round. */
  abstract SortedSet<String> draw(Rng draws);

  /** The logical time of the request that comes now. */
  abstract long time();

  /** Whom the view lists. */
  List<RobotId> listed() {
    return all;
  }

  /** Whose consent a request needs, this robot's own included. */
  List<RobotId> asked() {
    return all;
  }

  abstract void request(SortedSet<String> sections);

  abstract boolean isIn();

  abstract void exit();

  /** Called again and again, whatever the robot does. */
  void tick() {}

  @Override
  public List<Object> callStarL() {
    gvh.trace.action(SOURCE, "view", id, View.closed(ids(listed())));
    for (int round = 1; round <= ROUNDS; round++) {
      pause(1 + rng.nextInt(8));
      SortedSet<String> sections = draw(rng);
      gvh.trace.action(SOURCE, "do_mutex", id, round, time(), text(sections), text(ids(asked())));
      request(sections);
      while (!isIn()) {
        pause(1);
      }
      gvh.trace.action(SOURCE, "od_mutex", id, round, text(sections));
      pause(2 + rng.nextInt(6));
      gvh.trace.action(SOURCE, "release", id, round, text(sections), "");
      exit();
    }
    while (true) {
      pause(1);
    }
  }

  private void pause(int ticks) {
    for (int i = 0; i < ticks; i++) {
      sleep(TICK_MS);
      tick();
    }
  }

  /** Tells that this robot consents. */
  final void tellGrant(RobotId to, long number) {
    gvh.trace.action(SOURCE, "grant", id, id(to), number);
  }

  private static List<ProcessId> ids(List<RobotId> robots) {
    return robots.stream().map(Contender::id).toList();
  }

  private static ProcessId id(RobotId robot) {
    return new ProcessId(robot, 1);
  }

  private static String text(Iterable<?> names) {
    List<String> texts = new ArrayList<>();
    names.forEach(name -> texts.add(name.toString()));
    return texts.stream().sorted().collect(Collectors.joining(" "));
  }

  static SortedSet<String> sections(String... names) {
    return new TreeSet<>(List.of(names));
  }
}
