package org.starl.primitives.specimen;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexFact;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/** A robot that asks for sections again and again; how access is agreed upon is the specimen. */
abstract class Contender extends LogicThread {

  static final String XID = "specimen";

  private static final Instance SOURCE = Instance.of(MutexFact.PRIMITIVE, XID);
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
    tell(new MutexFact.Learned(id, View.closed(ids(listed()))));
    for (int round = 1; round <= ROUNDS; round++) {
      pause(1 + rng.nextInt(8));
      SortedSet<String> sections = draw(rng);
      SortedSet<ProcessId> known = new TreeSet<>(ids(asked()));
      tell(new MutexFact.DoMutex(id, round, time(), sections, known));
      request(sections);
      while (!isIn()) {
        pause(1);
      }
      tell(new MutexFact.OdMutex(id, round, sections));
      pause(2 + rng.nextInt(6));
      tell(new MutexFact.Release(id, round, sections, Sections.NONE));
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
    tell(new MutexFact.Grant(id, id(to), number));
  }

  private void tell(MutexFact fact) {
    gvh.trace.action(SOURCE, MutexFact.SHAPE, fact);
  }

  private static List<ProcessId> ids(List<RobotId> robots) {
    return robots.stream().map(Contender::id).toList();
  }

  private static ProcessId id(RobotId robot) {
    return ProcessId.first(robot, 1);
  }

  static SortedSet<String> sections(String... names) {
    return new TreeSet<>(List.of(names));
  }
}
