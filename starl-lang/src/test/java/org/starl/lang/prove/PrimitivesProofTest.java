package org.starl.lang.prove;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
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
        "MutexProtocol_decls",
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

  /** Of requests for sets, as in {@code pvs/MutexProtocol_safety}. */
  private static final String PROTOCOL_IS_A_MUTEX =
      """

      invariant Of_sets_alone: parts = {}

      invariant Whole:
        forall i: PIDS, y, z: Zones ::
          y in crit_set(i) and z in want(i) => z in crit_set(i)

      refines group: Mutex_group_decls[PIDS, Zones] by
        mux.crit_set := crit_set,
        mux.req_set := [i: PIDS -> want(i) minus crit_set(i)],
        mux.rest_set := [i: PIDS -> {}],
        plist := plist,
        request(i, RS, P, in_parts) is do_mutex(i, RS, P),
        known(i, P) is known(i, P),
        enter(i, G) is od_mutex(i, G),
        release(i, RS) is release(i, RS),
        withdraw(i) is withdraw(i)
      """;

  @Test
  void protocolOfTheMutexIsTheMutexWithLists(@TempDir Path folder)
      throws IOException, SourceErrors {
    for (String name : List.of("Mutex_decls", "Mutex_group_decls", "MutexProtocol_decls")) {
      Files.copy(source(name), folder.resolve(name + ".starl"));
    }
    Path protocol = folder.resolve("MutexProtocol_decls.starl");
    String ofSets =
        Files.readString(protocol)
            .replace("pre not active?(i), RS != {}", "pre not in_parts, not active?(i), RS != {}");
    Files.writeString(protocol, ofSets + PROTOCOL_IS_A_MUTEX);
    Report report = prove(new SourceReader().read(protocol).getLast());
    assertThat(report.isProved()).isTrue();
    assertThat(report.claim("Inv_heard").orElseThrow().verdict()).isEqualTo(Verdict.PROVED);
    assertThat(report.claim("refinement group")).isPresent();
  }

  /** What speaks of quorums, Z3 does not decide: it is proved in {@code pvs/Synod_safety}. */
  @Test
  void synodKeepsWhatSpeaksOfNoQuorum() throws IOException, SourceErrors {
    String all = Files.readString(source("Synod_decls"));
    String first = all.substring(0, all.indexOf("// Votes are asked for in safe ballots only."));
    Report report = prove(new SourceReader().read("first.starl", first).getLast());
    for (String name : List.of("Inv_rounds", "OneValue", "Inv_votes", "Inv_promises")) {
      assertThat(report.claim(name).orElseThrow().verdict()).as(name).isEqualTo(Verdict.PROVED);
    }
  }

  /** Z3 finds such states, and spends its limit when it is asked for small ones. */
  @Test
  void statesThatCannotBeMadeSmallAreToldAll() throws IOException, SourceErrors {
    String wrong =
        Files.readString(source("MutexProtocol_decls"))
            .replace("(j in plist(i) or j in heard(i))", "j in plist(i)");
    Report report = prove(new SourceReader().read("wrong.starl", wrong).getLast());
    assertThat(report.claim("Exclusive").orElseThrow().isGood()).isFalse();
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
    return new SourceReader().read(source(name)).getFirst();
  }

  private static Path source(String name) {
    return Path.of("../pvs/starl").resolve(name + ".starl").toAbsolutePath();
  }
}
