plugins {
    `java-library`
    antlr
    id("maven-publish")
}

description = "Reads automata in StarL's language, and makes Java and PVS of them; explores and proves them"

configurations.api {
    // The plugin hands on its tool; the parser needs its runtime alone.
    setExtendsFrom(extendsFrom.filterNot { it.name == "antlr" })
}

dependencies {
    antlr(libs.antlr.tool)
    api(libs.jspecify)
    implementation(project(":starl-core-input"))
    implementation(libs.antlr.runtime)
    implementation(libs.lsp4j)
    implementation(libs.z3)
    testImplementation(project(":starl-core"))
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

tasks.generateGrammarSource {
    arguments = listOf("-no-listener", "-package", "org.starl.lang.grammar")
}

tasks.processResources {
    // StarL's own automata, which programs use.
    from("../pvs/starl") {
        into("org/starl/lang/library")
    }
}
