package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.ledger.Seen.PA;
import static org.starl.primitives.ledger.Seen.PA2;
import static org.starl.primitives.ledger.Seen.PB;
import static org.starl.primitives.ledger.Seen.T;
import static org.starl.primitives.ledger.Seen.U;
import static org.starl.primitives.ledger.Seen.WHAT;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import net.jqwik.api.statistics.Statistics;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.ledger.LedgerEntry.Add;
import org.starl.primitives.ledger.LedgerEntry.Begin;
import org.starl.primitives.ledger.LedgerEntry.Claim;
import org.starl.primitives.ledger.LedgerEntry.Finish;
import org.starl.primitives.ledger.LedgerEntry.Free;
import org.starl.primitives.ledger.LedgerEntry.Reopen;
import org.starl.primitives.ledger.LedgerEntry.Start;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** What any log does, with any entries in any order: they come from robots that are late, wrong or gone. */
class LedgerStateTest {

  private static final List<LedgerEntry> ALL = all();

  private static List<LedgerEntry> all() {
    List<LedgerEntry> all = new ArrayList<>();
    for (ProcessId who : List.of(PA, PA2, PB)) {
      all.add(new Start(who));
      for (TaskId task : List.of(T, U)) {
        for (long claim = 1; claim <= 4; claim++) {
          all.add(new Claim(task, claim, who));
          all.add(new Begin(task, claim, who));
          all.add(new Finish(task, claim, who));
        }
      }
    }
    for (TaskId task : List.of(T, U)) {
      all.add(new Add(task, WHAT));
      for (long claim = 1; claim <= 4; claim++) {
        all.add(new Free(task, claim));
        all.add(new Reopen(task, claim));
      }
    }
    return all;
  }

  /** Half of the entries are such as the log allows. */
  private static LedgerEntry next(LedgerState state, int pick) {
    List<LedgerEntry> allowed = ALL.stream().filter(state::allows).toList();
    List<LedgerEntry> from = pick % 2 == 0 || allowed.isEmpty() ? ALL : allowed;
    return from.get(pick / 2 % from.size());
  }

  private static byte[] bytes(LedgerState state) {
    return WireWriter.toBytes(out -> LedgerState.SHAPE.write(state, out));
  }

  @Example
  void aTaskIsClaimedByItsRobotsPresentProgramOnly() {
    LedgerState state = new LedgerState();
    for (LedgerEntry entry : List.of(new Start(PA), new Start(PA2), new Add(T, WHAT))) {
      assertThat(state.apply(entry)).isTrue();
    }
    for (ProcessId absent : List.of(PA, PB)) {
      assertThat(state.allows(new Claim(T, 1, absent))).as("%s", absent).isFalse();
    }
    assertThat(state.allows(new Claim(T, 1, PA2))).isTrue();
  }

  /** What a robot is told of a change that the log does not allow, or no longer. */
  @Example
  void theOutcomeOfEachEntryIsWhatTheLogSays() {
    LedgerState state = new LedgerState();
    expect(state, LedgerOutcome.PENDING, new Start(PA), new Add(T, WHAT), new Add(U, WHAT));
    expect(state, LedgerOutcome.LATE, new Claim(T, 1, PA), new Finish(T, 1, PA), new Free(T, 1));
    apply(state, new Start(PA), new Add(T, WHAT));
    expect(state, LedgerOutcome.DONE, new Start(PA), new Add(T, WHAT), new Free(T, 1));
    expect(state, LedgerOutcome.LATE, new Add(T, Value.EMPTY), new Begin(T, 1, PA));
    expect(state, LedgerOutcome.PENDING, new Claim(T, 1, PA));
    expect(state, LedgerOutcome.PENDING, new Claim(T, 1, PB)); // once PB has started
    expect(state, LedgerOutcome.LATE, new Claim(T, 2, PA), new Finish(T, 1, PA));
    expect(state, LedgerOutcome.DONE, new Reopen(T, 1));
    apply(state, new Claim(T, 1, PA));
    expect(state, LedgerOutcome.DONE, new Claim(T, 1, PA));
    expect(state, LedgerOutcome.LATE, new Claim(T, 1, PB), new Reopen(T, 1), new Finish(T, 1, PA));
    expect(state, LedgerOutcome.PENDING, new Begin(T, 1, PA), new Free(T, 1));
    expect(state, LedgerOutcome.DONE, new Reopen(T, 0));
    apply(state, new Begin(T, 1, PA));
    expect(state, LedgerOutcome.DONE, new Begin(T, 1, PA));
    expect(state, LedgerOutcome.LATE, new Free(T, 1));
    expect(state, LedgerOutcome.PENDING, new Finish(T, 1, PA), new Reopen(T, 1));
    expect(state, LedgerOutcome.LATE, new Finish(T, 1, PB), new Finish(T, 2, PA));
    apply(state, new Start(PA2));
    expect(state, LedgerOutcome.PENDING, new Finish(T, 1, PA)); // it may be under way
    expect(state, LedgerOutcome.PENDING, new Finish(T, 1, PA2));
    apply(state, new Reopen(T, 1), new Claim(T, 2, PA2));
    expect(state, LedgerOutcome.DONE, new Reopen(T, 1), new Free(T, 1));
    apply(state, new Begin(T, 2, PA2), new Finish(T, 2, PA2));
    expect(state, LedgerOutcome.DONE, new Finish(T, 2, PA2), new Free(T, 2), new Add(T, WHAT));
    expect(state, LedgerOutcome.LATE, new Claim(T, 3, PA2), new Begin(T, 2, PA2));
    expect(state, LedgerOutcome.LATE, new Finish(U, 1, PA2), new Free(U, 1));
  }

  private static void expect(LedgerState state, LedgerOutcome outcome, LedgerEntry... entries) {
    for (LedgerEntry entry : entries) {
      assertThat(state.outcome(entry)).as("%s", entry).isEqualTo(outcome);
    }
  }

  private static void apply(LedgerState state, LedgerEntry... entries) {
    for (LedgerEntry entry : entries) {
      assertThat(state.apply(entry)).as("%s", entry).isTrue();
    }
  }

  /** Sizes must fit the two bytes of the wire. */
  @Example
  void aLedgerHasItsMostTasksAndSources() {
    LedgerState state = new LedgerState();
    state.apply(new Start(PA));
    int most = 0xFFFF;
    for (int i = 1; i <= most; i++) {
      Add add = new Add(new TaskId("s" + i, 1), Value.EMPTY);
      assertThat(state.apply(add)).isTrue();
    }
    Add another = new Add(new TaskId("s1", 2), Value.EMPTY);
    assertThat(state.allows(another)).as("one task too many").isFalse();
    apply(state, new Claim(new TaskId("s7", 1), 1, PA), new Begin(new TaskId("s7", 1), 1, PA));
    apply(state, new Finish(new TaskId("s7", 1), 1, PA));
    assertThat(state.allows(new Add(new TaskId("new", 1), Value.EMPTY))).as("a source").isFalse();
    assertThat(state.allows(another)).isTrue();
  }

  @Property(tries = 400, edgeCases = EdgeCasesMode.NONE)
  void noEntryTakesEffectTwiceAndATaskIsFinishedOnce(
      @ForAll @Size(min = 20, max = 120) List<@IntRange(max = 9_999) Integer> picks) {
    LedgerState state = new LedgerState();
    Set<LedgerEntry> effective = new HashSet<>();
    Set<TaskId> finished = new HashSet<>();
    for (int pick : picks) {
      LedgerEntry entry = next(state, pick);
      boolean isAllowed = state.allows(entry);
      byte[] before = bytes(state);
      assertThat(state.apply(entry)).isEqualTo(isAllowed);
      if (isAllowed) {
        assertThat(effective.add(entry)).as("%s", entry).isTrue();
        assertThat(state.outcome(entry)).as("%s", entry).isEqualTo(LedgerOutcome.DONE);
      } else {
        assertThat(bytes(state)).isEqualTo(before);
      }
      if (isAllowed && entry instanceof Finish done) {
        assertThat(finished.add(done.task())).isTrue();
      }
      assertThat(state.tasks()).doesNotContainKeys(finished.toArray(TaskId[]::new));
    }
    Statistics.label("a task was finished").collect(!finished.isEmpty());
  }

  /** Neither a lease that runs out nor a restart ends what is begun. */
  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void onlyItsFinishOrTheApplicationEndsABegunTask(
      @ForAll @Size(min = 20, max = 120) List<@IntRange(max = 9_999) Integer> picks) {
    LedgerState state = new LedgerState();
    int kept = 0;
    for (int pick : picks) {
      LedgerEntry entry = next(state, pick);
      LedgerTask<Value> before = state.task(T);
      state.apply(entry);
      boolean mayEnd =
          (entry instanceof Finish done && done.task().equals(T))
              || (entry instanceof Reopen open && open.task().equals(T));
      if (before != null && before.isBegun() && !mayEnd) {
        assertThat(state.task(T)).isEqualTo(before);
        kept++;
      }
    }
    Statistics.label("a begun task was kept").collect(kept > 0);
  }

  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void theBytesOfAStateAreTheState(
      @ForAll @Size(min = 20, max = 120) List<@IntRange(max = 9_999) Integer> picks) {
    LedgerState state = new LedgerState();
    LedgerState copied = new LedgerState();
    for (int pick : picks) {
      LedgerEntry entry = next(state, pick);
      copied = LedgerState.SHAPE.read(new WireReader(bytes(copied)));
      assertThat(copied.apply(entry)).isEqualTo(state.apply(entry));
      assertThat(bytes(copied)).isEqualTo(bytes(state));
    }
  }

  /** A change that a robot has proposed and was told is LATE is never made. */
  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void aLateChangeIsNeverMade(
      @ForAll @Size(min = 20, max = 120) List<@IntRange(max = 9_999) Integer> picks) {
    LedgerState state = new LedgerState();
    Set<LedgerEntry> proposed = new HashSet<>();
    Set<LedgerEntry> late = new HashSet<>();
    for (int pick : picks) {
      LedgerEntry entry = next(state, pick);
      ALL.stream().filter(state::allows).forEach(proposed::add);
      if (state.apply(entry)) {
        assertThat(late).doesNotContain(entry);
      }
      proposed.stream()
          .filter(each -> state.outcome(each) == LedgerOutcome.LATE)
          .forEach(late::add);
    }
    Statistics.label("something was late").collect(!late.isEmpty());
  }
}
