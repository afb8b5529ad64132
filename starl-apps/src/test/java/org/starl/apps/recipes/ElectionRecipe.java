package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.election.Election;
import org.starl.primitives.election.Leader;

/** A recipe of docs/primitives.md. */
final class ElectionRecipe extends LogicThread {

  private final Election election;

  ElectionRecipe(GlobalVarHolder gvh) {
    super(gvh);
    election = new Election(gvh, "team");
  }

  @Override
  public List<Object> callStarL() {
    do {
      election.do_election();
      await(() -> election.Leader().get().isElected() || election.failed().get());
    } while (election.failed().get());
    if (election.Leader().get() instanceof Leader.Name leader) {
      return List.of(leader.id().robot(), leader.term()); // send the term with each command
    }
    return List.of("a new election has begun");
  }
}
