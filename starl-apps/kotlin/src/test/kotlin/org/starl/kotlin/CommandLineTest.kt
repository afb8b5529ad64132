package org.starl.kotlin

import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readText
import org.assertj.core.api.Assertions.assertThat
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.starl.cli.Main

/** The command line with everything that comes with StarL: this module's app too. */
class CommandLineTest {

  private val root = Path.of("..", "..")

  private fun starl(vararg words: String): String {
    val out = StringWriter()
    val err = StringWriter()
    val status = Main.run(PrintWriter(out), PrintWriter(err), *words)
    assertThat(status).`as`("%s: %s", words.toList(), err).isZero()
    return out.toString()
  }

  @Test
  fun theAppInKotlinRuns(@TempDir folder: Path) {
    assertThat(starl("list")).contains("app lineup: ", "app hello: ")
    assertThat(starl("run", "lineup", "--seed", "7", "--png", "${folder.resolve("a.png")}"))
      .contains("4 of 4 robots", "lineup.one_line", "lineup.in_line")
    starl("verify-determinism", "lineup", "--seed", "7")
  }

  @Test
  fun theCommittedSchemasAreThoseOfTheCode() {
    assertThat(root.resolve("docs/scenario.schema.json").readText())
      .`as`("renew it: ./starl schema > docs/scenario.schema.json")
      .isEqualTo(starl("schema"))
    assertThat(root.resolve("docs/sweep.schema.json").readText())
      .`as`("renew it: ./starl schema sweep > docs/sweep.schema.json")
      .isEqualTo(starl("schema", "sweep"))
    assertThat(root.resolve("docs/deployment.schema.json").readText())
      .`as`("renew it: ./starl schema deployment > docs/deployment.schema.json")
      .isEqualTo(starl("schema", "deployment"))
  }

  @Test
  fun itsScenarioRuns() {
    starl("campaign", "${root.resolve("scenarios/lineup.yaml")}", "--seeds", "1..3")
  }

  @Test
  fun theLogicKnowsCoreAndPrimitivesAlone() {
    val logic = sources().filter { it.startsWith("package org.starl.apps.lineup.logic\n") }
    assertThat(logic).isNotEmpty()
    val imports = logic.flatMap { Regex("(?m)^import (.*)$").findAll(it).toList() }
    assertThat(imports.map { it.groupValues[1] })
      .isNotEmpty()
      .allMatch { it.startsWith("org.starl.") }
      .noneMatch { it.matches(Regex("org\\.starl\\.(sim|deploy|apps|cli|kotlin)\\..*")) }
  }

  @Test
  fun whatTheDocumentationShowsIsInTheSources() {
    val page = root.resolve("docs/kotlin.md").readText()
    val blocks = Regex("```kotlin\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(page).toList()
    assertThat(blocks).isNotEmpty()
    val sources = sources().map { it.squeezed() }
    for (block in blocks.map { it.groupValues[1].squeezed() }) {
      assertThat(sources).`as`(block).anyMatch { it.contains(block) }
    }
  }

  private fun sources(): List<String> =
    Files.walk(Path.of("src")).use { paths ->
      paths.filter { it.toString().endsWith(".kt") }.toList().map { it.readText() }
    }

  private fun String.squeezed() = replace(Regex("\\s+"), "")
}
