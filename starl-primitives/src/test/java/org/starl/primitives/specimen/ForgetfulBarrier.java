package org.starl.primitives.specimen;

import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.BarrierAction;
import org.starl.primitives.barrier.BarrierFact;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/**
 * Robots that meet at one barrier again and again. Each counts whom it has heard, and when it has
 * heard all it goes on and forgets the count, as the original StarL's barrier did: who has come into
 * the next generation already is forgotten as well, and everybody waits for ever.
 */
final class ForgetfulBarrier extends LogicThread {

  private static final String XID = "specimen";
  private static final Instance SOURCE = Instance.of(BarrierFact.PRIMITIVE, XID);
  private static final long GENERATIONS = 20;

  private final boolean isMended;
  private final List<RobotId> all;
  private final Rng rng;
  private final Endpoint<Word> endpoint;
  private final Map<Long, TreeSet<RobotId>> heard = new TreeMap<>();
  private final GvhCell<BarrierOutcome> outcome;
  private long generation;

  /**
   * @param isMended whether each generation has a count of its own
   */
  ForgetfulBarrier(GlobalVarHolder gvh, boolean isMended) {
    super(gvh);
    this.isMended = isMended;
    outcome = gvh.variable(SOURCE, BarrierFact.OUTCOME, BarrierOutcome.NONE_YET);
    all = gvh.id.participants().asList();
    rng = gvh.plat.entropy.fork("specimen");
    endpoint =
        gvh.comms.open(
            new Channel<>("barrier", XID, Word.CODEC),
            (from, word) -> count(word.number()).add(from));
  }

  private TreeSet<RobotId> count(long itsGeneration) {
    return heard.computeIfAbsent(isMended ? itsGeneration : 0, g -> new TreeSet<>());
  }

  @Override
  public List<Object> callStarL() {
    ProcessId me = id(gvh.id.name());
    SortedSet<ProcessId> members = new TreeSet<>();
    all.forEach(robot -> members.add(id(robot)));
    gvh.trace.action(SOURCE, BarrierFact.CREATED, new BarrierFact.Created(me, members));
    for (generation = 1; generation <= GENERATIONS; generation++) {
      sleep(50 + rng.nextInt(200));
      gvh.trace.action(SOURCE, BarrierFact.ARRIVE, new BarrierAction.arrive(me, generation));
      for (RobotId robot : all) {
        endpoint.sendReliably(robot, new Word("ARRIVED", generation));
      }
      await(() -> count(generation).size() == all.size());
      heard.remove(isMended ? generation : 0L);
      outcome.set(new BarrierOutcome.Passed(generation));
    }
    return List.of();
  }

  private static ProcessId id(RobotId robot) {
    return ProcessId.first(robot, 1);
  }
}
