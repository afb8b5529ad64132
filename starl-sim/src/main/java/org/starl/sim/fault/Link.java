package org.starl.sim.fault;

import java.util.Set;
import java.util.function.Function;
import org.starl.id.RobotId;
import org.starl.sim.net.LinkRule;
import org.starl.sim.net.Verdict;

/** The links that a fault affects: {@code from=bot1,to=bot2}. */
record Link(RobotSelector from, RobotSelector to) {

  /** Makes the rule of a fault when it begins. */
  @FunctionalInterface
  interface RuleMaker {

    /**
     * @param salt forks a copy's generator for this fault alone
     */
    LinkRule rule(FaultContext context, String salt);
  }

  /** Reads the links in {@code call}, on which the fault installs a rule. */
  static FaultAction rule(FaultArguments call, RuleMaker maker) {
    Link link =
        new Link(
            call.keyed("from", ArgumentType.ROBOTS, RobotSelector.ALL),
            call.keyed("to", ArgumentType.ROBOTS, RobotSelector.ALL));
    return install(context -> {
      String salt = Long.toString(context.rng().fork("copies").nextLong());
      return link.limit(maker.rule(context, salt), context);
    });
  }

  /** Installs a rule on the network while the fault lasts. */
  static FaultAction install(Function<FaultContext, LinkRule> maker) {
    return context -> context.target().network().install(maker.apply(context))::uninstall;
  }

  private LinkRule limit(LinkRule rule, FaultContext context) {
    if (from.isAll() && to.isAll()) {
      return rule;
    }
    Set<RobotId> senders = Set.copyOf(from.ends(context.target(), context.rng().fork("from")));
    Set<RobotId> receivers = Set.copyOf(to.ends(context.target(), context.rng().fork("to")));
    return copy ->
        (from.isAll() || senders.contains(copy.from()))
                && (to.isAll() || receivers.contains(copy.to()))
            ? rule.judge(copy)
            : Verdict.PASS;
  }
}
