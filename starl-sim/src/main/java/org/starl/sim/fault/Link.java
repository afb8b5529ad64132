package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.net.LinkRule;
import org.starl.sim.net.Verdict;

/** The links that a fault affects: from some robots to some robots. */
public record Link(RobotSelector from, RobotSelector to) {

  public static final Link ALL = new Link(RobotSelector.ALL, RobotSelector.ALL);

  static Link read(FaultArguments call) {
    return new Link(
        call.optional("from", RobotSelector::parse, RobotSelector.ALL),
        call.optional("to", RobotSelector::parse, RobotSelector.ALL));
  }

  List<String> arguments() {
    List<String> arguments = new ArrayList<>();
    if (!from.isAll()) {
      arguments.add("from=" + from);
    }
    if (!to.isAll()) {
      arguments.add("to=" + to);
    }
    return arguments;
  }

  /** Limits {@code rule} to copies on these links. */
  LinkRule limit(LinkRule rule, FaultTarget ward, Rng rng) {
    if (equals(ALL)) {
      return rule;
    }
    Set<RobotId> senders = new LinkedHashSet<>(from.pick(ward, rng.fork("from")));
    Set<RobotId> receivers = new LinkedHashSet<>(to.pick(ward, rng.fork("to")));
    return copy ->
        (from.isAll() || senders.contains(copy.from()))
                && (to.isAll() || receivers.contains(copy.to()))
            ? rule.judge(copy)
            : Verdict.PASS;
  }
}
