package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

/** A view takes the wishes of several robots at once, but not both of these. */
class ProposalTest {

  private static final ProcessId FENCER = ProcessId.first(new RobotId("fencer"), 1);
  private static final ProcessId SILENT = ProcessId.first(new RobotId("silent"), 1);
  private static final ProcessId OTHER = ProcessId.first(new RobotId("other"), 1);
  private static final View VIEW = View.NONE.next().with(FENCER).with(SILENT).with(OTHER);
  private static final Change CONFINE =
      new Change(
          null,
          List.of(),
          List.of(
              new Confinement(
                  SILENT, new TreeSet<>(List.of("A")), new TreeSet<>(List.of(FENCER)))));
  private static final Change LEAVE = new Change(null, List.of(FENCER), List.of());

  @Test
  void aFencerDoesNotLeaveInTheViewOfItsConfinement() {
    View next = new Proposal(VIEW).add(CONFINE).add(LEAVE).view();
    assertThat(next.ghost(SILENT)).isNotNull();
    assertThat(next.contains(FENCER)).isTrue();
  }

  @Test
  void aFencerIsNotConfinedInTheViewOfItsConfinement() {
    Confinement back = new Confinement(FENCER, new TreeSet<>(), new TreeSet<>(List.of(OTHER)));
    Change confineFencer = new Change(null, List.of(), List.of(back));
    View next = new Proposal(VIEW).add(CONFINE).add(confineFencer).view();
    assertThat(next.ghost(SILENT)).isNotNull();
    assertThat(next.contains(FENCER)).isTrue();
  }

  @Test
  void aConfinementWhoseFencerLeavesFirstDoesNotCount() {
    View next = new Proposal(VIEW).add(LEAVE).add(CONFINE).view();
    assertThat(next.contains(FENCER)).isFalse();
    assertThat(next.contains(SILENT)).isTrue();
  }

  @Test
  void aConfinementByAFencerThatIsAdmittedInTheSameViewDoesNotCount() {
    Change join = new Change(FENCER, List.of(), List.of());
    View next = new Proposal(VIEW.without(FENCER)).add(join).add(CONFINE).view();
    assertThat(next.contains(FENCER)).isTrue();
    assertThat(next.contains(SILENT)).isTrue();
  }

  @Test
  void aConfinementWhoseFencerIsAGhostDoesNotCount() {
    View ghost = VIEW.confined(FENCER, new TreeSet<>(List.of("B")));
    assertThat(new Proposal(ghost).add(CONFINE).view()).isEqualTo(ghost.next());
  }

  @Test
  void aGhostStaysAdmittedByTheViewThatAdmittedIt() {
    View.Ghost ghost = new Proposal(VIEW).add(CONFINE).view().ghost(SILENT);
    assertThat(ghost).isEqualTo(new View.Ghost(1, new TreeSet<>(List.of("A"))));
  }

  @Test
  void aGhostIsNotAdmittedAgain() {
    View ghost = VIEW.confined(SILENT, new TreeSet<>(List.of("A")));
    View next = new Proposal(ghost).add(new Change(SILENT, List.of(), List.of())).view();
    assertThat(next).isEqualTo(ghost.next());
  }

  @Test
  void anotherRobotLeavesInTheViewOfAConfinement() {
    Change leave = new Change(null, List.of(OTHER), List.of());
    View next = new Proposal(VIEW).add(CONFINE).add(leave).view();
    assertThat(next.ghost(SILENT)).isNotNull();
    assertThat(next.contains(OTHER)).isFalse();
  }

  @Test
  void aFencerOfAConfinementThatFindsNoRoomMayLeave() {
    SortedSet<String> sections = new TreeSet<>();
    for (int i = 0; i < 30; i++) {
      sections.add("a-section-with-a-long-name-" + i);
    }
    Confinement tooMuch = new Confinement(SILENT, sections, new TreeSet<>(List.of(FENCER)));
    View view = VIEW;
    while (ViewFormat.fits(tooMuch.applyTo(view))) {
      view = view.with(ProcessId.first(new RobotId("member" + view.ids().size()), 1));
    }
    View next =
        new Proposal(view).add(new Change(null, List.of(), List.of(tooMuch))).add(LEAVE).view();
    assertThat(next.ghost(SILENT)).isNull();
    assertThat(next.contains(FENCER)).isFalse();
  }
}
