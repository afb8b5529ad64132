package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The recipes in docs are the files that {@code RecipesTest} runs. */
class RecipePagesTest {

  private static final Path ROOT = Path.of("..");
  private static final Path RECIPES = Path.of("../starl-apps/src/test/java/org/starl/apps/recipes");
  private static final List<String> PAGES =
      List.of("docs/primitives.md", "docs/from-the-first-starl.md");
  private static final Pattern JAVA = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);
  private static final Pattern NAME = Pattern.compile("final class (\\w+Recipe) ");

  @Test
  void everyRecipeIsShownAsItRuns() throws IOException {
    Set<String> shown = new TreeSet<>();
    for (String page : PAGES) {
      Matcher block = JAVA.matcher(Files.readString(ROOT.resolve(page)));
      while (block.find()) {
        Matcher name = NAME.matcher(block.group(1));
        assertThat(name.find())
            .as("a Java block of %s is a recipe: %s", page, block.group(1))
            .isTrue();
        String file = Files.readString(RECIPES.resolve(name.group(1) + ".java"));
        assertThat(withoutSpace(file)).as(page).contains(withoutSpace(block.group(1)));
        shown.add(name.group(1));
      }
    }
    try (Stream<Path> files = Files.list(RECIPES)) {
      assertThat(
              files
                  .map(file -> file.getFileName().toString())
                  .filter(n -> n.endsWith("Recipe.java")))
          .containsExactlyInAnyOrderElementsOf(shown.stream().map(name -> name + ".java").toList());
    }
  }

  @Test
  void theBlocksAboutThePatrolAreItsCode() throws IOException {
    StringBuilder patrol = new StringBuilder();
    for (String part : List.of("App", "Spec", "Demo")) {
      patrol.append(withoutSpace(Files.readString(RECIPES.resolve("Patrol" + part + ".java"))));
    }
    String page = Files.readString(ROOT.resolve("docs/your-own-app.md"));
    int from = page.indexOf("## Variables, a monitor and a demo");
    Matcher block = JAVA.matcher(page.substring(from, page.indexOf("\n## ", from + 1)));
    int blocks = 0;
    while (block.find()) {
      assertThat(patrol).contains(withoutSpace(block.group(1)));
      blocks++;
    }
    assertThat(blocks).isEqualTo(5);
  }

  private static String withoutSpace(String code) {
    return code.replaceAll("\\s+", "");
  }
}
