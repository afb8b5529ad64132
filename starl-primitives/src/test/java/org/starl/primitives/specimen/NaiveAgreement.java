package org.starl.primitives.specimen;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementAction;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.Value;
import org.starl.trace.Instance;

/** Robots that propose a value each, and agree on one in ways that come to mind first. */
final class NaiveAgreement extends LogicThread {

  private static final String XID = "specimen";
  private static final Instance SOURCE = Instance.of(AgreementFact.PRIMITIVE, XID);
  private static final long PATIENCE_MS = 2_000;

  /** How they agree. */
  enum Way {
    /** On what was heard first. */
    FIRST_HEARD,
    /** On the sum of all, as if it were one of them. */
    SUM_OF_ALL,
    /** On the least, once all are there: as datagrams get lost, maybe never. */
    LEAST_OF_ALL
  }

  private final Way way;
  private final RobotId me;
  private final List<RobotId> all;
  private final Endpoint<Word> endpoint;
  private final SortedMap<RobotId, Long> heard = new TreeMap<>();
  private final GvhCell<Decision<?>> decided;
  private long first = -1;

  NaiveAgreement(GlobalVarHolder gvh, Way way) {
    super(gvh);
    this.way = way;
    decided = gvh.variable(SOURCE, AgreementFact.DECIDED, new Decision.NoneYet<>());
    me = gvh.id.name();
    all = gvh.id.participants().asList();
    endpoint = gvh.comms.open(new Channel<>("agreement", XID, Word.CODEC), this::received);
  }

  private void received(RobotId from, Word word) {
    first = first < 0 ? word.number() : first;
    heard.put(from, word.number());
  }

  @Override
  public List<Object> callStarL() {
    gvh.trace.action(SOURCE, AgreementFact.ACCEPTORS, new AgreementFact.Acceptors(all));
    long mine = 1 + all.indexOf(me);
    heard.put(me, mine);
    gvh.trace.action(
        SOURCE, AgreementFact.PROPOSE, new AgreementAction.propose(me, value(mine).toString()));
    endpoint.broadcast(new Word("PROPOSE", mine));
    switch (way) {
      case FIRST_HEARD -> {
        await(() -> first >= 0, PATIENCE_MS);
        decide(first < 0 ? mine : first);
      }
      case SUM_OF_ALL -> {
        sleep(PATIENCE_MS);
        decide(100 + heard.values().stream().mapToLong(Long::longValue).sum());
      }
      case LEAST_OF_ALL -> {
        await(() -> heard.size() == all.size());
        decide(1);
      }
    }
    return List.of();
  }

  private void decide(long value) {
    decided.set(new Decision.Decided<>(value, value(value)));
  }

  private static Value value(long number) {
    return Value.write(out -> out.i64(number));
  }
}
