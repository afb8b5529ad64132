package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;

/**
 * PVS evaluates the theories of some random automata, and makes the same of each step as Java and
 * {@code starl check}. Needs PVS in {@code PVS_HOME}.
 */
@Tag("long")
class RandomTheoriesTest {

  private static final int AUTOMATA = 5;
  private static final int STEPS = 4;

  /** Prints the value of each claim. To interpret them takes a third of the time of compiling them. */
  private static final String EVALUATE =
      """
      (progn
        (setf sb-ext:*evaluator-mode* :interpret)
        (sb-ext:without-package-locks (setf (fdefinition 'compile) #'identity))
        (change-workspace "%s" t)
        (typecheck-file "random" nil nil nil t)
        (dolist (name '(%s))
          (let* ((th (get-typechecked-theory name))
                 (*current-context* (saved-context th)))
            (dolist (d (theory th))
              (when (and (const-decl? d) (search "claim_" (string (id d))))
                (format t "~&starl: ~a ~a ~a~%%" name (id d)
                  (handler-case (eval (pvs2cl (definition d)))
                    (error (e) (substitute #\\space #\\newline (format nil "~a" e)))))))))
        (bye 0))
      """;

  /** PVS evaluates no quantifier over naturals or over a parameter, and no equality of lists. */
  private static boolean isEvaluated(String action) {
    return Stream.of(": nat ::", " subset ", " disjoint ", "q = [i]").noneMatch(action::contains);
  }

  @Test
  void pvsMakesTheSameOfEachStep(@TempDir Path folder)
      throws IOException, InterruptedException, SourceErrors {
    String home = System.getenv("PVS_HOME");
    assumeTrue(home != null, "PVS_HOME is not set");
    StringBuilder text = new StringBuilder();
    List<String> names = new ArrayList<>();
    List<String> claims = new ArrayList<>();
    for (int seed = 1; seed <= AUTOMATA; seed++) {
      Random random = new Random(seed);
      String source = RandomAutomataTest.source(random, RandomTheoriesTest::isEvaluated);
      String name = "random_" + seed;
      var automaton = new SourceReader().read("x.starl", source).getFirst();
      RandomTheory theory = new RandomTheory(name, automaton);
      RandomAutomataTest.agree(random, source, STEPS, theory::add);
      names.add('"' + name + '"');
      theory.claims().forEach(claim -> claims.add("starl: " + name + " " + claim + " T"));
      text.append(theory.text()).append('\n');
    }
    Files.writeString(folder.resolve("random.pvs"), text);
    for (String used : List.of("time_machine.pvs", "zone_lists.pvs")) {
      Files.copy(Path.of("../pvs", used), folder.resolve(used));
    }
    Process pvs =
        new ProcessBuilder(
                home + "/pvs", "-raw", "-E", EVALUATE.formatted(folder, String.join(" ", names)))
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .start();
    pvs.getOutputStream().close();
    String output = new String(pvs.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    pvs.waitFor();
    assertThat(claims).hasSizeGreaterThan(AUTOMATA * STEPS);
    assertThat(output.lines().filter(line -> line.startsWith("starl: ")))
        .as(output)
        .containsExactlyElementsOf(claims);
  }
}
