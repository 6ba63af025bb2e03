# Writes OUTPUT, a source file that holds the text of every shader in FOLDER, so that the
# executable needs none of them when it runs. Called by the build as
#   cmake -DFOLDER=… -DOUTPUT=… -P embed_shaders.cmake
file(GLOB shaders ${FOLDER}/*.vert ${FOLDER}/*.frag ${FOLDER}/*.glsl)
set(entries "")
foreach(shader ${shaders})
  get_filename_component(name ${shader} NAME)
  file(READ ${shader} text)
  string(APPEND entries "  if (file == \"${name}\") return R\"glsl(${text})glsl\";\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"common/graphics/shader.hpp\"

std::string_view timestep::embedded_shader(std::string_view file) {
${entries}  return {};
}
")
