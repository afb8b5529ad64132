package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.starl.Version;

/** The poms that a release publishes: the bill of materials, the versions, the metadata. */
class PublishedPomsTest {

  private static final Repository REPOSITORY = Repository.here();
  private static final String PARENT = REPOSITORY.text("pom.xml");
  private static final String BOM = REPOSITORY.text("starl-bom/pom.xml");

  private static List<String> all(String tag, String pom) {
    List<String> found = new ArrayList<>();
    Matcher matcher =
        Pattern.compile("<" + tag + ">(.*?)</" + tag + ">", Pattern.DOTALL).matcher(pom);
    while (matcher.find()) {
      found.add(matcher.group(1).strip());
    }
    return found;
  }

  @Test
  void theBillOfMaterialsListsEveryModule() {
    List<String> libraries =
        all("module", PARENT.split("<profiles>")[0]).stream()
            .filter(module -> !module.equals("starl-bom"))
            .map(module -> module.replace('/', '-'))
            .toList();
    List<String> listed = all("artifactId", all("dependencyManagement", BOM).get(0));
    assertThat(listed).containsExactlyElementsOf(libraries);
    assertThat(BOM).doesNotContain("<parent>");
  }

  @Test
  void everyPomAndTheProgramHaveOneVersion() {
    assertThat(all("version", BOM).get(0)).isEqualTo(Version.STARL);
    assertThat(all("version", PARENT).get(0)).isEqualTo(Version.STARL);
    for (String module : all("module", PARENT)) {
      String pom = REPOSITORY.text(module + "/pom.xml");
      assertThat(all("version", pom).get(0)).as(module).isEqualTo(Version.STARL);
    }
  }

  @Test
  void everyPomHasTheMetadataThatARepositoryAsksFor() {
    for (String tag : List.of("url", "licenses", "developers", "scm")) {
      assertThat(all(tag, PARENT)).as(tag).isNotEmpty();
      assertThat(all(tag, BOM)).as(tag).isEqualTo(all(tag, PARENT));
    }
    for (String module : all("module", PARENT)) {
      String pom = REPOSITORY.text(module + "/pom.xml");
      assertThat(all("name", pom)).as(module).isNotEmpty();
      assertThat(all("description", pom)).as(module).isNotEmpty();
    }
  }
}
