package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The Maven build and the Gradle build are one: modules, dependencies, scopes, versions. */
class BuildParityTest {

  private static final Repository REPOSITORY = Repository.here();
  private static final Build MAVEN = MavenBuild.read(REPOSITORY::text);
  private static final Build GRADLE = GradleBuild.read(REPOSITORY::text);
  private static final String CATALOG = "gradle/libs.versions.toml";

  @Test
  void theTwoBuildsAgree() {
    assertThat(MAVEN.dependencies()).hasSizeGreaterThan(25);
    // The platform's number is JUnit's own, one major version behind.
    assertThat(GRADLE.versions().get("junit-platform"))
        .isEqualTo(GRADLE.versions().get("junit").replaceFirst("^5", "1"));
    assertThat(Build.differences(MAVEN, GRADLE)).isEmpty();
  }

  @Test
  void sparkRosAndTheServerAreMattersOfTheirModulesAlone() {
    assertThat(MAVEN.dependencies())
        .filteredOn(needed -> needed.needed().matches("org\\.apache\\.spark:.*|.*:starl-cli-spark"))
        .extracting(Dependency::module, Dependency::scope)
        .containsExactly(tuple("starl-cli/spark", "provided"));
    assertThat(MAVEN.dependencies())
        .filteredOn(needed -> needed.needed().matches("us\\.ihmc:.*|.*:starl-android-ros2"))
        .extracting(Dependency::module)
        .containsExactly("starl-android/ros2");
    assertThat(MAVEN.dependencies())
        .filteredOn(needed -> needed.needed().matches("io\\.javalin:.*|.*:starl-cli-serve"))
        .extracting(Dependency::module)
        .containsExactly("starl-cli/serve");
    String always = REPOSITORY.text("pom.xml").split("<profiles>")[0];
    assertThat(always)
        .doesNotContain(
            "<module>starl-cli/spark</module>",
            "<module>starl-android/ros2</module>",
            "<module>starl-cli/serve</module>");
  }

  @Test
  void aVersionThatDriftsIsTold() {
    assertThat(differencesWith(CATALOG, "picocli = \"", "picocli = \"9."))
        .anyMatch(line -> line.startsWith("version picocli: Maven has "))
        .anyMatch(line -> line.startsWith("Gradle alone has Dependency[module=starl-cli"));
  }

  @Test
  void aScopeThatDriftsIsTold() {
    assertThat(
            differencesWith(
                "starl-cli/build.gradle.kts",
                "testImplementation(libs.arch",
                "implementation(libs.arch"))
        .hasSize(2)
        .anyMatch(line -> line.startsWith("Maven alone has ") && line.contains("scope=test"));
  }

  @Test
  void whatIsOnlyForCompilingStaysSo() {
    assertThat(differencesWith("starl-sim/build.gradle.kts", "compileOnly(", "implementation("))
        .anyMatch(line -> line.startsWith("Maven alone has ") && line.contains("scope=provided"));
  }

  @Test
  void settingsThatDoNotReadThePomAreRefused() {
    assertThatThrownBy(() -> differencesWith("settings.gradle.kts", "pom.xml\")", "other.xml\")"))
        .hasMessageContaining("does not include the modules of pom.xml");
  }

  @Test
  void anotherReleaseOfJavaIsTold() {
    assertThat(differencesWith("build.gradle.kts", "release.set(21)", "release.set(17)"))
        .contains("Java release: Maven has 21, Gradle 17");
  }

  @Test
  void aLineThatIsNotUnderstoodIsRefused() {
    assertThatThrownBy(() ->
            differencesWith("starl-sim/build.gradle.kts", "api(libs.jspecify)", "api(\"a:b:1\")"))
        .hasMessageContaining("not understood: api(\"a:b:1\")");
  }

  @Test
  void theMavenPropertiesOfLibrariesAreInTheCatalog() {
    // What Maven alone needs: the gates and the formatter.
    assertThat(MAVEN.versions().keySet()).containsAll(GRADLE.versions().keySet());
    assertThat(MAVEN.versions().keySet())
        .filteredOn(name -> !GRADLE.versions().containsKey(name))
        .containsExactly("errorprone", "google-java-format", "nullaway", "project");
  }

  /** The launcher puts all modules into one jar: one of two would be lost. */
  @Test
  void noTwoModulesHaveResourcesOfOneName() {
    assertThat(REPOSITORY.paths())
        .filteredOn(path -> path.contains("/src/main/resources/"))
        .hasSizeGreaterThan(5)
        .extracting(path -> path.replaceFirst(".*/src/main/resources/", ""))
        .doesNotHaveDuplicates();
  }

  private static List<String> differencesWith(String file, String old, String changed) {
    Build gradle =
        GradleBuild.read(path -> {
          String text = REPOSITORY.text(path);
          if (!path.equals(file)) {
            return text;
          }
          assertThat(text).contains(old);
          return text.replace(old, changed);
        });
    return Build.differences(MAVEN, gradle);
  }
}
