package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Ballot;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class ViewFormatTest {

  /** The number is the decree's. */
  @Test
  void aViewThatListsAProcessOfALaterOneIsRefusedOnArrival() {
    ProcessId process = ProcessId.first(new RobotId("a"), 1);
    View later = new View(9, new TreeMap<>(Map.of(process, 9L)), new TreeMap<>());
    Value value = ViewFormat.toValue(later);
    Ballot ballot = new Ballot(1, process);
    Shape<SynodMessage> shape = SynodCodec.of(new ViewFormat());
    for (long number : new long[] {8, 9}) {
      for (SynodMessage message :
          List.of(
              new SynodMessage.Decided(number, value),
              new SynodMessage.Accept(number, ballot, value),
              new SynodMessage.Promise(
                  number, ballot, new SynodMessage.Vote(ballot, value), List.of()))) {
        WireReader in =
            new WireReader(WireWriter.toBytes(out -> SynodMessage.SHAPE.write(message, out)));
        if (number == 9) {
          assertThat(shape.read(in)).isEqualTo(message);
        } else {
          assertThatThrownBy(() -> shape.read(in)).isInstanceOf(WireFormatException.class);
        }
      }
    }
  }

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void aViewIsReadAsItWasWritten(@ForAll("views") View view) {
    assertThat(ViewFormat.fits(view)).isTrue();
    assertThat(ViewFormat.read(view.number(), ViewFormat.toValue(view))).isEqualTo(view);
  }

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void aViewIsReadFromItsJson(@ForAll("views") View view) throws JsonFormatException {
    JsonReader in = new JsonReader("a", 1, View.SHAPE.json(view));
    assertThat(View.SHAPE.readJson(in)).isEqualTo(view);
  }

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void aChangeIsReadAsItWasWritten(@ForAll("views") View view, @ForAll boolean joins) {
    List<ProcessId> ids = view.ids();
    Change change =
        joins && !ids.isEmpty()
            ? new Change(ids.get(0), ids.subList(1, ids.size()), confinements(view))
            : new Change(null, ids, confinements(view));
    assertThat(Change.fromValue(change.toValue())).isEqualTo(change);
  }

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void damagedBytesAreReadOrRefused(@ForAll("views") View view, @ForAll int at, @ForAll byte with) {
    byte[] bytes = ViewFormat.toValue(view).bytes();
    bytes[Math.floorMod(at, bytes.length)] = with;
    for (Value damaged :
        List.of(Value.of(bytes), Value.of(Arrays.copyOf(bytes, bytes.length - 1)))) {
      try {
        assertThat(ViewFormat.read(view.number(), damaged).number()).isEqualTo(view.number());
      } catch (WireFormatException refused) {
        assertThat(refused).hasMessageMatching(".+");
      }
      try {
        assertThat(Change.fromValue(damaged).leave()).isNotNull();
      } catch (WireFormatException refused) {
        assertThat(refused).hasMessageMatching(".+");
      }
    }
  }

  @Test
  void aViewThatListsAnIdOfALaterViewIsRefused() {
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    admitted.put(ProcessId.first(new RobotId("bot1"), 1), 5L);
    Value value = ViewFormat.toValue(new View(5, admitted));
    assertThatThrownBy(() -> ViewFormat.read(4, value)).isInstanceOf(WireFormatException.class);
  }

  @Test
  void aViewThatListsAnIdTwiceIsRefused() {
    ProcessId id = ProcessId.first(new RobotId("bot1"), 1);
    Value value =
        Value.write(out -> {
          out.u8(ViewFormat.toValue(View.NONE).bytes()[0]);
          out.u16(2);
          out.process(id);
          out.i64(1);
          out.process(id);
          out.i64(1);
          out.u16(0);
        });
    assertThatThrownBy(() -> ViewFormat.read(4, value))
        .isInstanceOf(WireFormatException.class)
        .hasMessage("bot1 after bot1");
  }

  @Test
  void fortyRobotsFitAViewAndAHundredDoNot() {
    assertThat(ViewFormat.fits(viewOf(40))).isTrue();
    assertThat(ViewFormat.fits(viewOf(100))).isFalse();
  }

  /** The confinement of each ghost, by the first free id. */
  private static List<Confinement> confinements(View view) {
    List<Confinement> all = new ArrayList<>();
    List<ProcessId> fencers = view.ids().subList(0, Math.min(1, view.ids().size()));
    view.ghosts()
        .forEach(
            (id, ghost) -> all.add(new Confinement(id, ghost.sections(), new TreeSet<>(fencers))));
    return all.subList(0, Math.min(3, all.size()));
  }

  private static View viewOf(int robots) {
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    for (int i = 0; i < robots; i++) {
      admitted.put(ProcessId.first(new RobotId("bot" + i), 1), 1L);
    }
    return new View(1, admitted);
  }

  @Provide
  Arbitrary<View> views() {
    Arbitrary<ProcessId> ids =
        Combinators.combine(
                Arbitraries.integers().between(0, 30), Arbitraries.longs().greaterOrEqual(1))
            .as((bot, inc) -> new ProcessId(new RobotId("bot" + bot), inc));
    Arbitrary<Set<String>> sections =
        Arbitraries.strings().withChars("AB.:-_9").ofMinLength(1).ofMaxLength(6).set().ofMaxSize(3);
    return Combinators.combine(
            Arbitraries.longs().between(1, 1_000_000),
            Arbitraries.maps(ids, Arbitraries.longs().between(1, 1_000_000)).ofMaxSize(12),
            Arbitraries.maps(ids, sections).ofMaxSize(8))
        .as((number, free, occupied) -> {
          SortedMap<ProcessId, Long> admitted = new TreeMap<>();
          free.forEach((id, by) -> admitted.put(id, Math.min(by, number)));
          SortedMap<ProcessId, View.Ghost> ghosts = new TreeMap<>();
          occupied.forEach((id, names) -> {
            if (!admitted.containsKey(id) && !names.isEmpty()) {
              ghosts.put(id, new View.Ghost(1 + number / 2, Sections.copyOf(names)));
            }
          });
          return new View(number, admitted, ghosts);
        });
  }
}
