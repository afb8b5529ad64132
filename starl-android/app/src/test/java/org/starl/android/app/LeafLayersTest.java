package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.launch.DeploymentFile;

/**
 * Dependencies of the phone app: a class that is not in the APK would be missing only on the phone.
 */
class LeafLayersTest {

  private static final ArchRule LAW =
      ArchRuleDefinition.classes()
          .should()
          .onlyDependOnClassesThat(
              JavaClass.Predicates.resideInAnyPackage(
                      "java..",
                      "android..",
                      "org.jspecify..",
                      "org.starl",
                      "org.starl.body..",
                      "org.starl.comms..",
                      "org.starl.geometry..",
                      "org.starl.gvh..",
                      "org.starl.id..",
                      "org.starl.input..",
                      "org.starl.motion..",
                      "org.starl.platform..",
                      "org.starl.random..",
                      "org.starl.spec..",
                      "org.starl.time..",
                      "org.starl.trace..",
                      "org.starl.primitives..",
                      "org.starl.robot..",
                      "org.starl.android.app..",
                      "com.fasterxml.jackson.core..",
                      "com.fasterxml.jackson.dataformat.yaml..")
                  .or(
                      DescribedPredicate.describe(
                          "factories",
                          type ->
                              List.of("AppFactory", "Parameter", "Request", "RobotProgram")
                                  .contains(type.getName().replace("org.starl.apps.", ""))))
                  .or(DescribedPredicate.describe("primitive types", JavaClass::isPrimitive)));

  /** Violates the rule. */
  private static final class TakesTheCommandLinesReader {
    Object read() {
      return DeploymentFile.read("my.yaml");
    }
  }

  @Test
  void theAppUsesOnlyAllowedDependencies() {
    var leaf =
        new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(location -> !location.contains("/run/test-classes/"))
            .importPackages("org.starl.android.app");
    assertThat(leaf).hasSizeGreaterThan(10);
    assertThat(LAW.evaluate(leaf).getFailureReport().getDetails()).isEmpty();
  }

  @Test
  void aForbiddenDependencyIsFound() {
    var wrong = new ClassFileImporter().importClasses(TakesTheCommandLinesReader.class);
    assertThat(LAW.evaluate(wrong).hasViolation()).isTrue();
  }
}
