package org.starl.lang.prove;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.prove.Claim.Verdict;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** The primitives' automata, as they stand in {@code pvs/starl}. */
@Tag("long")
class PrimitivesProofTest {

  private static final long LIMIT = 10_000_000;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Mutex_decls",
        "Mutex_group_decls",
        "Pipeline_decls",
        "Modes_decls",
        "Registration_decls",
        "SetAgreement_decls",
        "Election_decls",
        "Barrier_decls",
        "Ledger_decls",
        "Geocast_decls",
        "MotionControl_decls"
      })
  void primitivesKeepTheirInvariantsForAnyNumberOfRobots(String name)
      throws IOException, SourceErrors {
    Report report = prove(read(name));
    assertThat(report.claims()).extracting(Claim::verdict).containsOnly(Verdict.PROVED);
  }

  @Test
  void intersectionKeepsItsInvariants() throws IOException, SourceErrors {
    Report report = prove(read("Traffic_decls"));
    assertThat(report.isProved()).isTrue();
    assertThat(report.claim("Held").orElseThrow().verdict()).isEqualTo(Verdict.PROVED);
    assertThat(report.claim("Peers").orElseThrow().verdict()).isEqualTo(Verdict.PROVED);
  }

  /** The program of the intersection's second car. */
  @Test
  void carOfFigure3KeepsItsInvariants() throws IOException, SourceErrors {
    Path file = Path.of("../starl-apps/src/main/starl/IcpProgram.starl").toAbsolutePath();
    Report report = prove(new SourceReader().read(file).getLast());
    assertThat(report.isProved()).isTrue();
    assertThat(report.claim("Traffic_safety")).isPresent();
    assertThat(report.claim("Occupied_is_held").orElseThrow().verdict()).isEqualTo(Verdict.PROVED);
  }

  private static Report prove(Automaton automaton) {
    return new Prover(automaton, LIMIT, (name, text) -> {}).prove();
  }

  private static Automaton read(String name) throws IOException, SourceErrors {
    Path file = Path.of("../pvs/starl").resolve(name + ".starl").toAbsolutePath();
    return new SourceReader().read(file).getFirst();
  }
}
