package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Label;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** A search that was saved finds, in another process, what it would have found. */
class CheckpointTest {

  private static final int ALL = 1_000_000;

  /** All kinds of values; progress needs the steps, too. */
  private static final String KINDS =
      """
      automaton Kinds[PIDS]
      type Light = dark | lit(by: PIDS, n: nat)
      type Pair = record(left: bool, right: option[PIDS])
      state
        light: [PIDS -> Light]
        pair: Pair
        seen: set[PIDS]
        last: list[PIDS]
        t: time
      start t = 0.5, seen = {}, last = [], pair.left = false, pair.right = none,
        forall i: PIDS :: light(i) = dark
      action light_up(i: PIDS)
        pre light(i) = dark
        eff light(i) := lit(i, card(seen)), seen := seen union {i}
      action note(i: PIDS)
        pre i in seen, not pair.left
        eff pair.left := true, pair.right := some(i), last := [i] ++ last
      action rest fair
        pre not pair.left
        eff t := t + 1
      invariant Lit: forall i: PIDS :: light(i) is lit => light(i).by = i
      progress Noted: eventually pair.left
      """;

  private static Automaton automaton(String source) throws SourceErrors {
    return new SourceReader().read("a.starl", source).getLast();
  }

  private static Search search(Automaton automaton, boolean isSymmetric, int most) {
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton).forEach(type -> opaque.put(type, opaque.isEmpty() ? 3 : 2));
    Sizes sizes = new Sizes(opaque, 2, 2);
    return new Search(new Machine(automaton, sizes), sizes, Map.of(), isSymmetric, most);
  }

  private static byte[] saved(Checkpoint checkpoint) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    checkpoint.write(out, "what");
    return out.toByteArray();
  }

  private static Search goingOn(Automaton automaton, boolean isSymmetric, byte[] saved)
      throws IOException {
    Search search = search(automaton, isSymmetric, ALL);
    Path file = Files.createTempFile("search", "");
    try {
      Files.write(file, saved);
      assertThat(Checkpoint.key(file)).isEqualTo("what");
      search.checkpoint().read(file);
    } finally {
      Files.delete(file);
    }
    return search;
  }

  /** Interrupts at {@code after} states, or has room for so many alone. */
  private static void endsAlike(Automaton automaton, boolean isSymmetric, int after)
      throws IOException {
    Search whole = search(automaton, isSymmetric, ALL);
    Search.Result expected = whole.run();
    for (boolean isFull : new boolean[] {false, true}) {
      Search early = search(automaton, isSymmetric, isFull ? after : ALL);
      Checkpoint checkpoint = early.checkpoint();
      Search.Result result = early.run(() -> !isFull && early.next() >= after);
      if (!result.stopped().isEmpty() && checkpoint.isMarked()) {
        Search later = goingOn(automaton, isSymmetric, saved(checkpoint));
        assertThat(later.run()).isEqualTo(expected);
        assertThat(later.visited()).hasSameElementsAs(whole.visited());
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 7, 20, 50})
  void eachKindOfValueIsSaved(int after) throws IOException, SourceErrors {
    endsAlike(automaton(KINDS), false, after);
  }

  @ParameterizedTest
  @ValueSource(strings = {"Mutex_decls", "SetAgreement_decls"})
  void primitivesGoOn(String name) throws IOException, SourceErrors {
    Path file = Path.of("../pvs/starl").resolve(name + ".starl").toAbsolutePath();
    Automaton automaton = new SourceReader().read(file).getLast();
    endsAlike(automaton, true, 40);
  }

  @Property(tries = 60, shrinking = ShrinkingMode.OFF)
  @Label("a search that is saved anywhere ends as it would have ended")
  void anySearchGoesOn(@ForAll long seed) throws IOException, SourceErrors {
    Random random = new Random(seed);
    Automaton automaton = automaton(new RandomAutomaton(random).constrained());
    endsAlike(automaton, random.nextBoolean(), 1 + random.nextInt(40));
  }

  @Test
  void savedTwice() throws IOException, SourceErrors {
    Automaton automaton = automaton(KINDS);
    Search first = search(automaton, false, ALL);
    Checkpoint checkpoint = first.checkpoint();
    first.run(() -> first.next() >= 3);
    Search second = goingOn(automaton, false, saved(checkpoint));
    Checkpoint again = second.checkpoint();
    second.run(() -> second.next() >= 9);
    assertThat(goingOn(automaton, false, saved(again)).run())
        .isEqualTo(search(automaton, false, ALL).run());
  }

  @Test
  void damageIsTold() throws IOException, SourceErrors {
    Automaton automaton = automaton(KINDS);
    Search search = search(automaton, false, ALL);
    Checkpoint checkpoint = search.checkpoint();
    search.run(() -> search.next() >= 9);
    byte[] saved = saved(checkpoint);
    for (int length = 21; length < saved.length; length++) {
      byte[] cut = Arrays.copyOf(saved, length);
      assertThatThrownBy(() -> goingOn(automaton, false, cut)).isInstanceOf(IOException.class);
    }
    Search.Result expected = search(automaton, false, ALL).run();
    int told = 0;
    for (int at = 21; at < saved.length; at++) {
      byte[] changed = saved.clone();
      changed[at] ^= 4;
      try {
        // a bit that means nothing
        assertThat(goingOn(automaton, false, changed).run()).isEqualTo(expected);
      } catch (IOException e) {
        told++;
      }
    }
    assertThat(told).isGreaterThan(9 * (saved.length - 21) / 10);
  }

  @Test
  void anotherFileHasNoKey(@TempDir Path folder) throws IOException {
    Path file = Files.write(folder.resolve("other"), new byte[] {0, 13, 's'});
    assertThat(Checkpoint.key(file)).isEmpty();
    assertThat(Checkpoint.key(Files.createFile(folder.resolve("empty")))).isEmpty();
  }
}
