package org.starl.primitives.agreement;

import java.util.HexFormat;
import org.starl.id.RobotId;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** Events of an agreement, for tests; values are hexadecimal digits. */
final class Seen {

  private Seen() {}

  static Instance agreement(String xid) {
    return Instance.of(AgreementFact.PRIMITIVE, xid);
  }

  static Action proposes(long timeNs, RobotId robot, String xid, String value) {
    return Action.of(
        timeNs,
        robot,
        agreement(xid),
        AgreementFact.PROPOSE,
        new AgreementAction.propose(robot, value));
  }

  /** The robot shows a decision. */
  static Variable decides(long timeNs, RobotId robot, String xid, String value) {
    Value bytes = Value.of(HexFormat.of().parseHex(value));
    return shows(timeNs, robot, xid, new Decision.Decided<>(value, bytes));
  }

  /** The robot shows that it knows no decision. */
  static Variable knowsNone(long timeNs, RobotId robot, String xid) {
    return shows(timeNs, robot, xid, new Decision.NoneYet<>());
  }

  private static Variable shows(long timeNs, RobotId robot, String xid, Decision<?> decision) {
    return new Variable(timeNs, robot, agreement(xid), AgreementFact.DECIDED, decision);
  }
}
