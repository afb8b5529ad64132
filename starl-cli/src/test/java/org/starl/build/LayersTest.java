package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every module and package imports what it may (paper, figure 1: the layers), and nothing else. */
class LayersTest {

  private static final JavaClasses SHIPPED =
      new ClassFileImporter()
          .withImportOption(new ImportOption.DoNotIncludeTests())
          // Of `./starl test`: the option above does not know the folder target/run.
          .withImportOption(location -> !location.contains("/run/test-classes/"))
          .importPackages("org.starl");

  static Stream<Layers.Law> laws() {
    return Layers.LAWS.stream();
  }

  @Test
  void everyModuleIsSeen() {
    assertThat(SHIPPED)
        .extracting(c -> c.getPackageName())
        .contains(
            "org.starl",
            "org.starl.primitives.mutex",
            "org.starl.sim.kernel",
            "org.starl.robot.udp",
            "org.starl.cli");
  }

  @ParameterizedTest
  @MethodSource("laws")
  void theLawHolds(Layers.Law law) {
    ArchRule rule = law.rule();
    assertThat(rule.allowEmptyShould(true).evaluate(SHIPPED).getFailureReport().getDetails())
        .isEmpty();
  }

  @ParameterizedTest
  @MethodSource("laws")
  void aClassThatBreaksTheLawIsFound(Layers.Law law) {
    JavaClasses wrong = new ClassFileImporter().importClasses(law.brokenBy());
    assertThat(law.rule().evaluate(wrong).hasViolation()).isTrue();
  }
}
