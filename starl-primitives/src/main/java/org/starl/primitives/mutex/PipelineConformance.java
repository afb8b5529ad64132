package org.starl.primitives.mutex;

import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.PipelineAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Replay;

/**
 * Every run of every mutex with sequences is a run of the theory {@code Pipeline_decls}. A mutex
 * without them is left to {@link MutexConformance}, one with modes to {@link ModesConformance}.
 */
public final class PipelineConformance extends GrantConformance<States, PipelineAction> {

  public PipelineConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public PipelineConformance(AutomatonListener<States, PipelineAction> steps) {
    super(
        PipelineAutomaton.PIPELINE_DECLS,
        "every mutex with sequences",
        new Pipeline(),
        source -> new Replay<>(new PipelineAutomaton(), source, steps));
  }

  @Override
  boolean begins(MutexFact.DoMutex request) {
    return !request.sequence().isEmpty();
  }

  @Override
  boolean ends(MutexFact.DoMutex request) {
    return Sections.haveMode(request.want());
  }

  private static final class Pipeline implements Theory<States, PipelineAction> {
    @Override
    public PipelineAction ask(RobotId i, List<String> sections, long ticket) {
      return new PipelineAction.do_sequence(i, sections, ticket);
    }

    @Override
    public PipelineAction grant(RobotId i, String section, States state) {
      return new PipelineAction.grant(i, section);
    }

    @Override
    public PipelineAction release(RobotId i, SortedSet<String> given) {
      return new PipelineAction.release(i, given);
    }

    @Override
    public PipelineAction withdraw(RobotId i) {
      return new PipelineAction.withdraw(i);
    }

    @Override
    public PipelineAction restart(RobotId i) {
      return new PipelineAction.restart(i);
    }

    @Override
    public PipelineAction standsIn(RobotId i, SortedSet<String> sections) {
      return new PipelineAction.stands_in(i, sections);
    }

    @Override
    public SortedSet<String> crit(RobotId i, States state) {
      return state.crit_set().at(i);
    }

    @Override
    public SortedSet<String> rest(RobotId i, States state) {
      return state.rest_set().at(i);
    }

    @Override
    public Collection<String> asked(RobotId i, States state) {
      return state.req().at(i);
    }
  }
}
